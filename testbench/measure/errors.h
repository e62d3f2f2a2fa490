// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>

#include "testbench/measure/float_picture.h"

namespace feline {

// How far a picture is from another one, in linear light, 1 is full, over the colour channels of the texture. The
// outermost pixels are left out.
struct Errors {
  double mean_square = 0;
  double worst = 0;  // of one channel
  int worst_column = 0;
  int worst_row = 0;

  double rmse() const;
  double psnr() const;  // decibels below full; infinity for equal pictures
};
nlohmann::ordered_json to_json(const Errors& errors);
Errors errors_from_json(const nlohmann::ordered_json& json);
Errors compare(const FloatPicture& picture, const FloatPicture& truth, int channels);

// Of a sequence: the mean square of the change of the error from one frame to the next, which the eye sees as shimmer.
double temporal_mean_square(const FloatPicture& before, const FloatPicture& truth_before, const FloatPicture& after,
                            const FloatPicture& truth_after, int channels);

double psnr_of(double mean_square);

}  // namespace feline

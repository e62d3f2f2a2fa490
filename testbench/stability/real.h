// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gmpxx.h>
#include <mpfr.h>

#include <cstdint>
#include <utility>

namespace feline {

// A real number of 200 bits (MPFR), rounded to nearest: 150 bits more than any table needs.
class Real {
 public:
  Real() {
    static thread_local const Caches caches;
    mpfr_init2(value_, 200), mpfr_set_zero(value_, 1);
  }
  Real(double value) : Real() { mpfr_set_d(value_, value, MPFR_RNDN); }  // NOLINT(google-explicit-constructor)
  Real(const Real& other) : Real() { mpfr_set(value_, other.value_, MPFR_RNDN); }
  Real& operator=(const Real& other) {
    mpfr_set(value_, other.value_, MPFR_RNDN);
    return *this;
  }
  ~Real() { mpfr_clear(value_); }
  static Real ratio(long numerator, long denominator) {
    Real result(static_cast<double>(numerator));
    mpfr_div_si(result.value_, result.value_, denominator, MPFR_RNDN);
    return result;
  }

  friend Real operator+(const Real& a, const Real& b) { return two(mpfr_add, a, b); }
  friend Real operator-(const Real& a, const Real& b) { return two(mpfr_sub, a, b); }
  friend Real operator*(const Real& a, const Real& b) { return two(mpfr_mul, a, b); }
  friend Real operator/(const Real& a, const Real& b) { return two(mpfr_div, a, b); }
  friend Real operator-(const Real& a) { return one(mpfr_neg, a); }
  friend bool operator<(const Real& a, const Real& b) { return mpfr_less_p(a.value_, b.value_) != 0; }
  friend bool operator>(const Real& a, const Real& b) { return mpfr_greater_p(a.value_, b.value_) != 0; }
  friend bool operator<=(const Real& a, const Real& b) { return mpfr_lessequal_p(a.value_, b.value_) != 0; }
  friend bool operator>=(const Real& a, const Real& b) { return mpfr_greaterequal_p(a.value_, b.value_) != 0; }
  friend bool operator==(const Real& a, const Real& b) { return mpfr_equal_p(a.value_, b.value_) != 0; }
  friend Real sqrt(const Real& a) { return one(mpfr_sqrt, a); }
  friend Real exp(const Real& a) { return one(mpfr_exp, a); }
  friend Real log2(const Real& a) { return one(mpfr_log2, a); }
  friend Real sin(const Real& a) { return one(mpfr_sin, a); }
  friend Real cos(const Real& a) { return one(mpfr_cos, a); }
  friend Real abs(const Real& a) { return one(mpfr_abs, a); }
  friend Real atan2(const Real& y, const Real& x) { return two(mpfr_atan2, y, x); }
  friend Real hypot(const Real& a, const Real& b) { return two(mpfr_hypot, a, b); }
  friend Real pow(const Real& a, const Real& b) { return two(mpfr_pow, a, b); }
  friend Real floor(const Real& a) {
    Real result;
    mpfr_floor(result.value_, a.value_);
    return result;
  }

  // The nearest multiple of 2^-fraction_bits, as an integer; no table value lies on a tie but exact ones.
  long rounded(int fraction_bits) const {
    Real scaled;
    mpfr_mul_2si(scaled.value_, value_, fraction_bits, MPFR_RNDN);
    Real whole;
    mpfr_round(whole.value_, scaled.value_);
    return mpfr_get_si(whole.value_, MPFR_RNDN);
  }
  long floored(int fraction_bits) const {
    Real scaled;
    mpfr_mul_2si(scaled.value_, value_, fraction_bits, MPFR_RNDN);
    return mpfr_get_si(scaled.value_, MPFR_RNDD);
  }
  double to_double() const { return mpfr_get_d(value_, MPFR_RNDN); }

 private:
  // What MPFR keeps for each thread, which ends with the thread only if told so.
  struct Caches {
    ~Caches() { mpfr_free_cache2(MPFR_FREE_LOCAL_CACHE); }
  };

  template <typename F>
  static Real one(F function, const Real& a) {
    Real result;
    function(result.value_, a.value_, MPFR_RNDN);
    return result;
  }
  template <typename F>
  static Real two(F function, const Real& a, const Real& b) {
    Real result;
    function(result.value_, a.value_, b.value_, MPFR_RNDN);
    return result;
  }

  mpfr_t value_;
};

}  // namespace feline

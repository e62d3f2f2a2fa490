# SPDX-License-Identifier: Apache-2.0
# The faults: the stage that must be named, what is broken, where, and how.

feline_rom_fault(footprint ellipse 120 3)
feline_rom_fault(footprint ellipse 200 29)
feline_rom_fault(walk weight 279 0)
feline_rom_fault(filter gaussian 77 0)
feline_rom_fault(plan log2 150 0)
feline_rom_fault(plan reciprocal 5 2)
feline_rom_fault(fetch srgb 99 0)

feline_fault(group outward_rounding_truncates feline_round_magnitude
             "nearest_i ? half : inexact" "inexact" "1'b0")
feline_fault(group nearest_rounding_is_outward feline_round_magnitude
             "assign half         = halves[0]" "halves[0]" "inexact")
feline_fault(group rounding_to_a_bit_less_drops_a_half feline_round_magnitude
             "assign half_more    = kept[0]" "kept[0]" "1'b0")
feline_fault(group table_rounds_outward feline_group
             "mode == feline_pkg::ModeSimple || mode == feline_pkg::ModeTable"
             "mode == feline_pkg::ModeTable" "1'b0")
feline_fault(group sign_lost feline_group_mantissas "negative_i[i] ? -magnitude" "negative_i[i]" "1'b0")
feline_fault(group overflow_of_rounding_missed feline_group_mantissas
             "assign halved   = too_large != '0" "too_large != '0" "1'b0")
feline_fault(group coordinate_tie_goes_down feline_float_to_position
             "SignificandWidth'(halves[0])" "SignificandWidth'(halves[0])" "SignificandWidth'(0)")
feline_fault(group saturation_one_octave_late feline_float_to_position
             "exponent >= SaturationExponent" "exponent >= SaturationExponent" "exponent > SaturationExponent")
feline_fault(group overflow_unflagged feline_group_mantissas
             "finite_i && exponent > MaxExponent" "finite_i" "1'b0")
feline_fault(group not_a_number_unseen feline_float_to_position
             "fraction != '0;" "fraction != '0" "1'b0")

feline_fault(footprint tie_goes_to_x feline_longer_vector
             "x_length > y_length" "x_length > y_length" "x_length >= y_length")
feline_fault(footprint length_takes_smaller_part feline_length "flat > steep" "flat > steep" "flat < steep")
feline_fault(footprint rotation_as_printed feline_table_footprint
             "assign major_v_o = VectorWidth'(longer_v_i) * doubled + VectorWidth'(longer_u_i)"
             "VectorWidth'(longer_u_i)" "VectorWidth'(longer_v_i)")
feline_fault(footprint turn_the_other_way feline_table_place
             "x_is_longer_i ^ cross_i[ProductWidth-1]" "x_is_longer_i" "!x_is_longer_i")
feline_fault(footprint radius_rounds_down feline_table_footprint
             "(MajorWidth'(1) << (ScaleBits - 1))" "(MajorWidth'(1) << (ScaleBits - 1))" "MajorWidth'(0)")
feline_fault(footprint tangent_tie feline_table_place
             "cross_size < dot_size" "cross_size < dot_size" "cross_size <= dot_size")

feline_fault(plan most_probes_count_as_limited feline_choose_probes
             "32'(wanted) > 32'(max_probes_i)" "32'(wanted) > 32'(max_probes_i)" "32'(wanted) >= 32'(max_probes_i)")
feline_fault(plan radius_never_widened feline_fit_radius "minor_i > widened" "minor_i > widened" "1'b1")
feline_fault(plan level_rounds_down feline_level_of_radius
             "(FractionBits + 2)'(aligned[DroppedBits-1])" "(FractionBits + 2)'(aligned[DroppedBits-1])" "0")
feline_fault(plan level_tie_goes_to_coarser feline_sampled_level "lambda) + BelowHalf" "BelowHalf" "BelowHalf + 1")
feline_fault(plan one_probe_too_many feline_choose_probes
             "probes_o = max_probes_i" "max_probes_i" "max_probes_i + 1'b1")
feline_fault(plan last_level_unseen feline_sampled_level "level < last" "level < last" "1'b1")
feline_fault(plan magnification_unseen feline_sampled_level "lambda == '0" "lambda == '0" "1'b0")
feline_fault(plan step_sign_lost feline_half_step "negative ? -rounded" "negative" "1'b0")
feline_fault(plan weight_row_of_one_probe_less feline_choose_weight_row
             "quarters < least" "quarters < least" "quarters < least - 1")

feline_fault(walk probes_run_the_other_way feline_probe_position
             "half_step_i * n_i" "half_step_i * n_i" "half_step_i * -n_i")
feline_fault(walk column_one_low feline_probe_weight
             "(distance + StepWidth'(1)) >> 1" "(distance + StepWidth'(1))" "(distance)")

feline_fault(walk plan_taken_with_its_first_probe feline_walk "beat_ready && last" "beat_ready && last" "beat_ready")

feline_fault(address clamp_at_one feline_wrap "whole > 0 ? One" "whole > 0" "whole > 1")
feline_fault(address mirror_not_turned feline_wrap
             "position_i[Fraction] ? One - repeated" "One - repeated" "repeated")
feline_fault(address repeat_wraps_to_wrong_end feline_axis_texels
             "below == (wrap_i == feline_pkg::WrapRepeat)" "wrap_i == feline_pkg::WrapRepeat"
             "wrap_i == feline_pkg::WrapMirroredRepeat")
feline_fault(address last_texel_is_outside feline_axis_texels
             "index >= $signed(LowWidth'(size_i))" "index >= $signed(LowWidth'(size_i))"
             "index > $signed(LowWidth'(size_i))")
feline_fault(address fraction_rounds_down feline_texel_coordinate
             "HalfUlp - HalfTexel" "HalfUlp - HalfTexel" "-HalfTexel")

feline_fault(fetch tag_ignored feline_tile_cache
             "valid_q[set] && line_q[set] == line_i[i*LineWidth +: LineWidth]"
             "line_q[set] == line_i[i*LineWidth +: LineWidth]" "1'b1")
feline_fault(fetch line_made_wrong_inside_the_cache feline_blocking_cache
             "line_q <= missing_line" "missing_line" "~missing_line")
feline_fault(fetch wrong_texel_of_word feline_decode_texel
             "word_i[column_i*CodeWidth +: CodeWidth]" "column_i" "column_i ^ 2'd1")

feline_fault(filter weight_of_wrong_texel feline_interpolate
             "$signed({1'b0, b_i}) - $signed({1'b0, a_i})" "$signed({1'b0, b_i})" "$signed({1'b0, b_i}) + 1")
feline_fault(filter gaussian_on_nearest_texels feline_filter
             "feline_pkg::KernelGaussian && fetch_i.linear" "fetch_i.linear" "1'b1")

feline_fault(accumulate sum_not_rounded feline_accumulate "weighted_q.first ? Half" "Half" "SumWidth'(0)")
feline_fault(accumulate sum_not_started_anew feline_accumulate "weighted_q.first ?" "weighted_q.first" "1'b0")
feline_fault(accumulate pixel_for_every_probe feline_accumulate
             "weighted_valid && weighted_q.last)" "weighted_valid && weighted_q.last" "weighted_valid")
feline_fault(accumulate pixel_lost_when_stalled feline_accumulate
             "beat_ready || !weighted_q.last" "beat_ready || !weighted_q.last" "1'b1")
# A stage swallows what it takes, or stops: it is named, however full everything before it is.
feline_fault(group swallows feline_group ".valid_i(request_valid_i)" "request_valid_i" "1'b0")
feline_fault(footprint swallows feline_footprint ".valid_i(products_valid)" "products_valid" "1'b0")
feline_fault(plan swallows feline_count_probes ".valid_i(choice_valid)" "choice_valid" "1'b0")
feline_fault(walk swallows feline_walk ".valid_i(plan_valid_i), .ready_o(beat_ready)" "plan_valid_i" "1'b0")
feline_fault(address swallows feline_level_address ".valid_i(texels_valid)" "texels_valid" "1'b0")
feline_fault(fetch line_never_taken feline_blocking_cache
             "memory_response_ready_o = state_q == Respond" "state_q == Respond" "1'b0")
feline_fault(filter swallows feline_filter ".valid_i(levels_valid)" "levels_valid" "1'b0")
feline_fault(accumulate swallows feline_accumulate ".valid_i(filter_valid_i)" "filter_valid_i" "1'b0")
# A beat comes again and again, or is taken too early.
feline_fault(address repeats_beats feline_level_address
             ".valid_o(texels_valid), .ready_i(texels_ready)" "texels_ready" "1'b0")
feline_fault(filter repeats_beats feline_filter ".valid_o(levels_valid), .ready_i(levels_ready)" "levels_ready" "1'b0")
feline_fault(fetch address_taken_before_its_lines_are_there feline_blocking_cache
             "words_ready_i && missing == '0" "missing == '0" "1'b1")

feline_fault(group never_busy feline_unit "in_flight_q != '0" "in_flight_q != '0" "1'b0")

// What reading the logs states: peculiarities of a file, and why rows of it are no samples.

#include "wording/messages.h"

namespace tribolog::wording {

const Messages& reading_messages() {
  static const Messages all{
      {"reading.of_file", values_alone("{file}: {note}")},

      // Text.
      {"reading.columns_by_position", text("no column names; columns are taken by their position")},
      {"reading.names_in_comment", text("column names are taken from the comment above the rows")},
      {"reading.echoed_joint_states",
       text("no column names; the rows are sensor_msgs/JointState, as ros2 topic echo --csv "
            "writes them")},
      {"reading.unclear_joint_states",
       by_count("rows",
                "{unclear} of {rows} row is left out (line {line}): it is of other joints, or does "
                "not show which of position, velocity and effort it has",
                "{unclear} of {rows} rows are left out (the first in line {line}): they are of "
                "other joints, or do not show which of position, velocity and effort they have")},
      {"reading.repeated_names", text("column names that occur more than once: {columns}")},
      {"reading.units_in_second_row", text("units are taken from the row under the header")},
      {"reading.columns_without_numbers",
       text("columns that hold no numbers are not read: {columns}")},
      {"reading.commas_in_numbers",
       text("column {column} is not read: {number} has a decimal comma, which --decimal-comma "
            "states, or a separator of thousands")},
      {"reading.lines_before_header",
       by_count("lines", "{lines} line in front of the header is not read",
                "{lines} lines in front of the header are not read")},
      {"reading.separated_by_semicolons", text("columns are separated by semicolons")},
      {"reading.separated_by_tabs", text("columns are separated by tabs")},
      {"reading.separated_by_spaces", text("columns are separated by spaces")},
      {"reading.decimal_comma", text("numbers have a decimal comma")},
      {"reading.mixed_line_ends", text("line ends are mixed (LF, CR LF, CR)")},
      {"reading.trailing_delimiter",
       text("rows end with a delimiter; the empty column is ignored")},
      {"reading.bad_rows",
       by_count("rows", "{bad} of {rows} row cannot be used and are left out; the first: {first}",
                "{bad} of {rows} rows cannot be used and are left out; the first: {first}")},
      {"reading.ends_inside_row",
       text("file ends inside a row at byte {byte} (log truncated?); the row is left out")},
      {"reading.no_last_line_end",
       text("the last row has no line end; if the log was cut off, its last number may be too")},
      {"reading.still_written",
       text(
           "the log is still being written; what was written after reading began is not included")},

      // Arrays and bags.
      {"reading.value", values_alone("{name} = {value}")},
      {"reading.more_values",
       by_count("values", "and {values} more single value", "and {values} more single values")},
      {"reading.more_not_read", by_count("arrays", "and {arrays} more that is not read",
                                         "and {arrays} more that are not read")},
      {"reading.not_read", text("{name} is not read: {why}")},
      {"reading.no_number_in_topic", text("{topic} is not read: no message holds a number")},
      {"reading.square_matrix",
       text("{array} is {rows} x {columns}: its first dimension is taken for the samples")},
      {"reading.column_renamed",
       text("column name {column} occurs twice; that of array {array} is now {name}")},
      {"reading.integers_rounded",
       text("{array} holds integers of 2^53 and more: they are rounded")},
      {"reading.lerobot_clock",
       text("the data set has no timestamps: its frames, {rate_Hz} in a second, are the clock")},
      {"reading.lerobot_without_effort",
       text(
           "no torque or current in observation.*: the motion can be looked at, and no friction be "
           "identified")},
      {"reading.long_format",
       by_count("readings",
                "{readings} row is a signal's reading ({signals}); those of the same time are one "
                "row here",
                "{readings} rows are a signal's reading each ({signals}); those of the same time "
                "are one row here")},
      {"reading.repeated_readings",
       by_count("readings", "{readings} reading is left out: its signal has one at that time",
                "{readings} readings are left out: their signal has one at that time")},
      {"reading.long_array", text("{topic}: {path} has more than 64 elements and was not read")},
      {"reading.too_many_columns",
       text("{topic}: a message has more numbers than columns can be kept")},
      {"reading.long_messages",
       by_count("messages", "{topic}: {longer} of {messages} message is longer than its type says",
                "{topic}: {longer} of {messages} messages are longer than their type says")},
      {"reading.log_time_goes_back",
       text("{topic}: rows are in the file's order; log_time goes back at {back} of {rows}")},
      {"reading.chunk_damaged", text("chunk (0x06) at byte {byte} is damaged: there is no record "
                                     "at its byte {at}; the rest of the chunk is left out")},
      {"reading.chunk_left_out", text("chunk (0x06) at byte {byte} is left out: {why}")},
      {"reading.messages_without_channel",
       text("messages left out because no channel record precedes them: {messages}")},
      {"reading.messages_without_topic",
       text("messages left out because they belong to no topic: {messages}")},
      {"reading.no_footer",
       text("ends at byte {byte} without a footer: the recording was not closed")},
      {"reading.damaged_record",
       text("damaged at byte {byte}: no record has opcode 0x00; what follows is not read")},
      {"reading.bag_chunk_damaged",
       text("chunk at byte {byte} is damaged: there is no record at its "
            "byte {at}; the rest of the chunk is left out")},
      {"reading.bag_chunk_left_out", text("chunk at byte {byte} is left out: {why}")},
      {"reading.damaged_bag",
       text("damaged at byte {byte}: no record starts there; what follows is not read")},
      {"reading.no_index", text("has no index: the recording was not closed")},
      {"reading.damaged_end",
       text("damaged at byte {byte}: the closing 8 bytes are not those of MCAP")},
      {"reading.bytes_after_end",
       text("{bytes} bytes after the log's end at byte {end} are not read")},
      {"reading.truncated",
       text("truncated in {record} at byte {byte}: expected {expected} bytes, ended after {got}")},
      {"reading.not_finalized",
       text("the recording was not finalized: its records are read as far as the file reaches")},
      {"reading.fewer_records", text("{group} states {stated:.0f} records; there are {records}")},
      {"reading.segment_not_closed",
       text("the segment at byte {byte} was not closed: it is read as far as the file reaches")},
      {"reading.not_closed", text("the recording was not closed: what is in {file} ({bytes} bytes) "
                                  "is not read; sqlite3 can merge it into the log")},

      // Recordings.
      {"reading.column_not_used", text("columns of the logs that are not used: {columns}")},
      {"reading.effort_not_read",
       text("columns that may be the torque or the current are not read: {columns}")},
      {"reading.gaps", text("column {column}: {percent:.0f} % of the rows are gaps (nan)")},
      {"reading.impossible_values",
       text(
           "column {column}: numbers that no joint has ({count}, such as {value:.6g}) are taken as "
           "gaps; in a manifest [log] skip_bad_rows = true leaves their rows out")},
      {"reading.clock_from_1970",
       text("its clock counts from 1970; here, and in from_s and to_s, time counts from its first "
            "reading, in whole units")},
      {"reading.past_midnight",
       by_count("midnights", "its clock shows the time of day and passes midnight {midnights} time",
                "its clock shows the time of day and passes midnight {midnights} times")},
      {"reading.lines_before_table",
       text("lines in front of the table: {lines}, read for its columns' names alone")},
      {"reading.remarks",
       text("lines of words among the rows: {lines}, left out; the first is {first}")},
      {"reading.register_without_sign",
       text("column {column} jumps between the ends of a register ({register}): its numbers were "
            "logged without their sign, and are read with it")},
      {"reading.clock_set_back",
       by_count("times",
                "the clock was set back {times} time while it was logged; it goes on from the row "
                "before by the usual step",
                "the clock was set back {times} times while it was logged; it goes on from the row "
                "before by the usual step")},
      {"reading.held_rows",
       text("{percent:.0f} % of the rows repeat the row before: the robot sends a sample every "
            "{rows} rows, and each is used once")},
      {"reading.time_runs_back",
       by_count("rows", "time runs backwards in {rows} row (first in line {line}); sorted by time",
                "time runs backwards in {rows} rows (first in line {line}); sorted by time")},
      {"reading.angle_unwrapped",
       by_count(
           "jumps",
           "the angle wraps round {jumps} time, at {first_s:.6g} s, by {period:.6g} {unit}: it "
           "is read as going on there",
           "the angle wraps round {jumps} times, first at {first_s:.6g} s, by {period:.6g} "
           "{unit}: it is read as going on there")},
      {"reading.large_angle",
       text("the joint's angle reaches {angle_rad:.4g} rad, read as {unit}: degrees?")},
      {"reading.large_torque",
       text("the joint's torque reaches {torque_Nm:.3g} N·m, read as {unit}: another unit, or the "
            "other side of the gear?")},
      {"reading.unlikely_rate",
       text("{rate_Hz:.3g} samples per second, read in {unit}: another unit of time?")},
      {"reading.slow_for_loops",
       text("{rate_Hz:.3g} samples per second are few to resolve a reversal; log at 100 or more")},
      {"reading.robot_of_other_joint",
       text("{file} describes the test of joint {described}, the manifest is for joint {stated}: "
            "the drawings of the robot show the former")},
      {"reading.arm_matched_by_order",
       text("no joint of {file} has a name of the manifest's: they are matched by their order, "
            "{joint} as {described}")},
      {"reading.arm_joints_at_zero",
       text("no column has the angles of {joints} of {file}: they are taken to stand at 0")},
      {"reading.others_not_logged",
       text("{file} has no angle of another joint: {description} takes nothing off its torque")},
      {"reading.outside_range_of_motion",
       text("the logs reach {angle_deg:.4g}°, outside the range of motion of joint {joint} in "
            "{file}, {lowest_deg:.4g}° to {highest_deg:.4g}°: do both count the angle from the "
            "same zero and with the same sign?")},

      // Why a row is not among the samples.
      {"skipped.outside_window", text("outside the window {window}")},
      {"skipped.gap", text("gap (nan) in column {column}")},
      {"skipped.impossible", text("a number that no joint has in column {column}")},
      {"skipped.repeated_stamp", text("repeated time stamp")},
      {"skipped.held", text("repeats the row before: logged faster than sampled")},
      {"skipped.point_at_rest", text("friction at rest, at no speed")},
      {"skipped.cut_off", text("cut off at the end of the file")},
      {"skipped.other_joint", text("another joint's row, as stated")},
      {"skipped.other_recording", text("another recording's row, as stated")},
      {"skipped.unclear_joint_state",
       text("of other joints, or not told which of position, velocity and effort it has")},
      {"skipped.not_usable", text("cannot be used (skip_bad_rows)")},
      {"skipped.at_rest", text("at rest before or after the motion")}};
  return all;
}

}  // namespace tribolog::wording

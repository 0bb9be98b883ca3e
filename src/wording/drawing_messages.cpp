// What laying out, drawing and checking a figure states.

#include "wording/messages.h"

namespace tribolog::wording {

const Messages& drawing_messages() {
  static const Messages all{
      // Parts of a figure, by their text or their number.
      {"drawing.series_labelled", text("series '{label}'")},
      {"drawing.series_numbered", text("series {number}")},
      {"drawing.series_of_panel", text("series {number} of panel {panel}")},
      {"drawing.band_labelled", text("band '{label}'")},
      {"drawing.band_numbered", text("band {number}")},
      {"drawing.band_of_panel", text("band {number} of panel {panel}")},
      {"drawing.block_labelled", text("block '{label}'")},
      {"drawing.block_numbered", text("block {number}")},
      {"drawing.wire_numbered", text("wire {number}")},
      {"drawing.line_labelled", text("line '{label}'")},
      {"drawing.line_numbered", text("line {number}")},
      {"drawing.text", text("the text '{text}'")},
      {"drawing.part", text("the part '{label}'")},

      // Figures as a whole.
      {"drawing.impossible_size",
       text("figure size {width} x {height} pixels is not possible; each "
            "side must be {smallest} to {largest}")},
      {"drawing.panels_and_scene", text("a figure has panels or a scene, not both")},
      {"drawing.panels_and_diagram",
       text("a figure has panels or a diagram, not both; its panels are not drawn")},
      {"drawing.text_not_valid",
       text("text that is not valid UTF-8 or holds control characters is shown as '?'")},
      {"drawing.no_glyph", text("the font has no glyph for '{characters}'; shown as '?'")},
      {"drawing.title_cut", text("a title was too long and was cut: {title}")},
      {"drawing.legend_cut", text("a legend text was too long and was cut: {text}")},

      // Charts.
      {"drawing.too_low_for_panels", text("the picture is too low for its panels")},
      {"drawing.axis_end_ignored",
       text("a fixed end of axis '{axis}' cannot be drawn; it was ignored")},
      {"drawing.axis_ends_ignored",
       text("the fixed ends of axis '{axis}' leave no range; ignored")},
      {"drawing.no_sample", text("{series} has no sample that can be drawn")},
      {"drawing.samples_not_finite",
       text("{series}: dropped {dropped} of {all} samples that are not finite")},
      {"drawing.samples_not_positive",
       text("{series}: dropped {dropped} of {all} samples that are not finite or not positive on a "
            "logarithmic axis")},
      {"drawing.band_not_finite",
       text("band '{label}': dropped {dropped} samples that are not finite")},
      {"drawing.error_bar_not_finite", text("an error bar is not finite; it was left out")},
      {"drawing.reference_line_not_finite",
       text("reference line '{label}' is not finite; it was left out")},
      {"drawing.point_not_finite", text("point '{label}' is not finite; it was left out")},
      {"drawing.point_outside_axes",
       text("point '{label}' lies outside its axes; it was left out")},

      // Diagrams.
      {"drawing.too_low_for_diagram", text("the picture is too low for its diagram")},
      {"drawing.impossible_length",
       text("the diagram has a length that cannot be drawn; it is left out")},
      {"drawing.outside_canvas", text("{what} lies outside the canvas")},
      {"drawing.does_not_fit", text("{text} does not fit into its block")},
      {"drawing.texts_overlap", text("{text} overlaps '{other}'")},
      {"drawing.text_on_block", text("{text} collides with {block}")},
      {"drawing.text_on_wire", text("{text} lies on a wire")},
      {"drawing.text_on_line", text("{text} lies on a line")},
      {"drawing.blocks_overlap", text("{block} overlaps {other}")},
      {"drawing.wire_without_length", text("{wire} has no length")},
      {"drawing.wire_ends_at_nothing", text("{wire} ends at nothing")},
      {"drawing.wire_through_block", text("{wire} runs through {block}")},
      {"drawing.letters_too_small",
       text("the letters are too small to read at a width of {width_px:.0f} px")},

      // Scenes.
      {"drawing.empty_scene", text("the scene is empty")},
      {"drawing.scene_without_size", text("the scene has no size, or is not finite")},
      {"drawing.scene_margin",
       text("the margin of a scene is {margin:.6f}; it must be 0 to below 0.45")},
      {"drawing.camera_without_direction",
       text("the scene's camera has no direction, or its 'up' lies along it")},
      {"drawing.camera_opening",
       text("the scene's camera has an opening angle of {opening_deg:.6f} degrees; it must be 0 "
            "(parallel) to below 90")},
      {"drawing.part_without_axis",
       text("the part '{label}' of the scene has no direction: its axis is zero or not finite")},
      {"drawing.part_without_length",
       text("the part '{label}' of the scene has no direction: its length is zero or not finite")},
      {"drawing.part_without_normal",
       text("the part '{label}' of the scene has no direction: its normal is zero or not finite")},
      {"drawing.part_without_zero_line", text("the part '{label}' of the scene has no direction: "
                                              "its zero line is zero or not finite")},
      {"drawing.named_outside", text("what '{text}' labels lies outside the picture")},
      {"drawing.text_cut", text("{text} was too long and was cut")},
      {"drawing.no_room_between",
       text("there is no room to keep the texts '{first}' and '{second}' apart")},

      // Whether the picture shows it.
      {"drawing.blank", text("the picture came out blank")},
      {"drawing.no_contrast", text("{what} cannot be told from the background")},
      {"drawing.not_visible",
       text("{what} is not visible in the picture: {found} of {expected} pixels show it")},
      {"drawing.hidden", text("{what} is hidden under what is drawn after it")},
      {"drawing.part_hidden", text("{part} is hidden by others, or outside the picture")},
      {"drawing.outside_axes", text("{what} lies outside its axes")},
      {"drawing.text_missing", text("{text} is missing in the picture")},
      {"drawing.other_driver",
       text("drawn by '{renderer}' instead of llvmpipe; pictures may differ "
            "between machines")},

      // The processes that draw.
      {"drawing.no_socket", text("no socket for a drawing process: {reason}")},
      {"drawing.no_process", text("no process for drawing: {reason}")},
      {"drawing.stack_does_not_start", text("the graphics stack does not start: {end}")},
      {"drawing.start_took_too_long",
       text("the graphics stack took too long to start and was stopped")},
      {"drawing.took_too_long", text("drawing took too long and was stopped")},
      {"drawing.process_lost", text("the drawing process was lost: {end}")},
      {"drawing.not_waited_for", text("waiting for the drawing processes failed")},
      {"drawing.stopped_by_signal", text("it was stopped by signal {signal} ({name})")},
      {"drawing.ended_with_status", text("it ended with status {status}")},
      {"drawing.last_words", text("{end}; its last output: {words}")},
      {"drawing.message_ends_early", text("message ends early")},
      {"drawing.message_damaged", text("message is damaged")},

      // The graphics stack.
      {"drawing.vtk", values_alone("VTK: {words}")},
      {"drawing.wrong_size", text("VTK gave a picture of the wrong size")},
      {"drawing.no_opengl_functions",
       text("VTK finds no OpenGL 3.2 functions (GLEW status {status})")},
      {"drawing.opengl_function_missing",
       text("OpenGL function {function} is missing; install the package libosmesa6")},
      {"drawing.foreign_opengl",
       text("OpenGL calls go to {library} instead of libOSMesa, figures would be white; start the "
            "program without LD_PRELOAD and without another libGL")},
      {"drawing.osmesa_without_functions", text("OSMesa knows no OpenGL functions")},
      {"drawing.osmesa_without_context", text("OSMesa gives no OpenGL 3.2 context; install the "
                                              "packages libosmesa6 and libgl1-mesa-dri")},
      {"drawing.install_egl", text("{what}; install the packages libegl1 and libgl1-mesa-dri")},
      {"drawing.egl_without_surfaceless_platform", text("EGL has no surfaceless platform")},
      {"drawing.egl_without_opengl", text("EGL has no OpenGL")},
      {"drawing.egl_without_configuration", text("EGL has no suitable configuration")},
      {"drawing.egl_without_context", text("EGL gives no OpenGL 3.2 context")},

      // Fonts and files.
      {"drawing.no_font", text("the font DejaVu Sans is not in {folders}; install the package "
                               "fonts-dejavu-core or set TRIBOLOG_FONT_DIR")},
      {"drawing.no_freetype", text("FreeType does not start")},
      {"drawing.font_not_readable",
       text("the font file {file} cannot be read; reinstall the package "
            "fonts-dejavu-core")},
      {"drawing.font_file_not_readable", text("the font file {file} cannot be read")},
      {"drawing.font_file_damaged", text("the font file {file} is damaged")},
      {"drawing.font_file_cut_off", text("the font file {file} is cut off")},
      {"drawing.font_not_embeddable",
       text("the font file {file} does not allow embedding in documents")},
      {"drawing.font_without_outlines", text("the font file {file} has no TrueType outlines")},
      {"drawing.font_without_table", text("the font file {file} has no table '{table}'")},
      {"drawing.font_without_glyph", text("the font file {file} has no glyph {glyph}")},
      {"drawing.font_table_too_short", text("a font file is damaged: a table is too short")},
      {"drawing.font_number_beyond_table",
       text("a font file is damaged: a number lies beyond its table")},
      {"drawing.glyph_cut_off", text("a font file is damaged: a glyph is cut off")},
      {"drawing.composed_glyph_cut_off",
       text("a font file is damaged: a composite glyph is cut off")},
      {"drawing.too_many_characters", text("a figure has too many different characters")},
      {"drawing.text_without_font", text("a text has no font")},
      {"drawing.solid_parts_not_drawn", text("the solid parts of a scene have to be drawn before "
                                             "they are put into {format}")},
      {"drawing.solid_parts_damaged", text("the picture of a scene's solid parts is damaged")},
      {"drawing.no_memory_to_compress", text("no memory for compressing a picture")},
      {"drawing.not_compressed", text("a picture could not be compressed")}};
  return all;
}

}  // namespace tribolog::wording

#pragma once
// What the module tribolog_vtk gives to the program.

#include "render/paint/painter.h"

/// The caller owns it. @throw tribolog::FigureError if no context can be made.
extern "C" __attribute__((visibility("default"))) tribolog::render::Painter* tribolog_vtk_painter(
    const tribolog::render::Font& font, tribolog::render::PainterThreads threads);

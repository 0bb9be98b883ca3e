#pragma once
// What a drawing process has to say as part of a message, for the process that makes words of it.

#include "base/statement.h"
#include "render/workers/message_channel.h"

namespace tribolog::render::workers {

void put_statement(Message& message, const Statement& statement);

/// @throw tribolog::FigureError if the message ends before the statement does, if what stands there
/// is no statement, or if it holds statements within statements more than eight deep.
Statement take_statement(Message& message);

}  // namespace tribolog::render::workers

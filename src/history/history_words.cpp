// What the history's states are called.

#include "history/comparison.h"
#include "history/joint_trend.h"

namespace tribolog::history {

Statement statement_of(ChangeWord word) {
  switch (word) {
    case ChangeWord::no_change_seen:
      return {"comparison.no_change_seen"};
    case ChangeWord::changed:
      return {"comparison.changed"};
    case ChangeWord::not_comparable:
      break;
  }
  return {"comparison.not_comparable"};
}

Statement statement_of(TrendState state) {
  switch (state) {
    case TrendState::too_few:
      return {"trend.too_few"};
    case TrendState::steady:
      return {"trend.steady"};
    case TrendState::recovered:
      return {"trend.recovered"};
    case TrendState::warning:
      break;
  }
  return {"trend.changed"};
}

}  // namespace tribolog::history

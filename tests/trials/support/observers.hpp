#pragma once

#include "trials/observer/observer.hpp"

namespace palpate::trials::test {

/// No noise but the internal one, no lapses, no bias.
inline ObserverParameters plain_observer() {
  ObserverParameters p{.name = "plain"};
  p.depth = {.mean = 4e-3, .between = 0, .within = 0};
  p.duration = {.mean = 0.6, .between = 0, .within = 0};
  p.weber_fraction = {.mean = 0.2, .between = 0, .within = 0};
  return p;
}

}  // namespace palpate::trials::test

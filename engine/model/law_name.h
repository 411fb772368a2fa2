// The laws of joints, as scenes and reports write them.
#pragma once

#include "engine/model/material.h"

namespace dda {

inline const char* law_name(InterfaceLaw law) {
  switch (law) {
    case InterfaceLaw::classical: return "classical";
    case InterfaceLaw::consistent: return "consistent";
    case InterfaceLaw::cubic: return "cubic";
    case InterfaceLaw::projected: return "projected";
  }
  return "";
}

}  // namespace dda

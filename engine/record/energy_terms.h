// The entries of the energy ledger by name, as files have them.
#pragma once

#include <array>

#include "engine/model/energy.h"

namespace dda {

// Stored now, and when the run began.
struct StoredTerm {
  const char* name;
  double EnergyLedger::*now;
  double StoredEnergy::*initial;
};

// Summed up since then: work and losses.
struct FlowTerm {
  const char* name;
  double EnergyLedger::*sum;
};

inline constexpr std::array stored_terms{
    StoredTerm{"kinetic", &EnergyLedger::kinetic, &StoredEnergy::kinetic},
    StoredTerm{"strain", &EnergyLedger::strain, &StoredEnergy::strain},
    StoredTerm{"contact", &EnergyLedger::contact, &StoredEnergy::contact},
    StoredTerm{"bolts", &EnergyLedger::bolts, &StoredEnergy::bolts},
    StoredTerm{"linings", &EnergyLedger::linings, &StoredEnergy::linings},
};

inline constexpr std::array flow_terms{
    FlowTerm{"external_work", &EnergyLedger::external_work},
    FlowTerm{"gravity_work", &EnergyLedger::gravity_work},
    FlowTerm{"friction", &EnergyLedger::friction},
    FlowTerm{"plastic", &EnergyLedger::plastic},
    FlowTerm{"radiated", &EnergyLedger::radiated},
    FlowTerm{"dashpot", &EnergyLedger::dashpot},
    FlowTerm{"damping", &EnergyLedger::damping},
    FlowTerm{"numerical", &EnergyLedger::numerical},
    FlowTerm{"law_changes", &EnergyLedger::law_changes},
    FlowTerm{"removed", &EnergyLedger::removed},
};

// The one value beside these is the largest.
static_assert(sizeof(EnergyLedger) == (2 * stored_terms.size() + flow_terms.size() + 1) * sizeof(double),
              "every entry of the ledger has a name");

}  // namespace dda

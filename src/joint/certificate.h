#pragma once
// What a calibration certificate says of who measured for whom, where and with what: the
// `[certificate]` of the manifest. Nothing is computed from it.

#include <optional>
#include <string>
#include <vector>

namespace tribolog::joint {

/// A measuring instrument. Texts but the name are empty where not stated.
struct Instrument {
  std::string name;
  std::string identification;  ///< Its serial or inventory number.
  std::string traceability;    ///< Number of its certificate, or a statement.
  std::string used_for;

  bool operator==(const Instrument&) const = default;
};

/// Texts are empty where not stated.
struct Certificate {
  std::string number;    ///< The laboratory's own.
  std::string replaces;  ///< Number of the certificate that this one replaces.
  std::string laboratory;
  std::string laboratory_address;
  std::string country;  ///< Of the laboratory: two capital letters (ISO 3166-1 alpha-2).
  std::string customer;
  std::string customer_address;
  std::string place;                       ///< Where it was measured.
  std::string received_on;                 ///< Free text or ISO date, as given.
  std::string procedure;                   ///< The laboratory's own, beside the method's.
  std::string conditions;                  ///< Beyond temperature and payload.
  std::optional<double> humidity_percent;  ///< Of the air, 0 to 100.
  std::string adjustment;                  ///< Results before and after an adjustment.
  std::string decision_rule;
  std::string responsible;  ///< Who authorises the certificate.
  std::vector<Instrument> instruments;

  bool operator==(const Certificate&) const = default;
};

}  // namespace tribolog::joint

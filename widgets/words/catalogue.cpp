#include "widgets/words/catalogue.h"

namespace alltact {

std::vector<const char*> library_patterns() {
  std::vector<const char*> all;
  for (const Patterns& some : {kJointWords,
                               kPressWords,
                               kCalibrationWords,
                               kAdviceWords,
                               kLensWords,
                               kReferenceWords,
                               kFingerWords,
                               kFileWords,
                               kSceneWords,
                               kDeviceWords,
                               kProgramWords})
    all.insert(all.end(), some.begin(), some.end());
  return all;
}

}  // namespace alltact

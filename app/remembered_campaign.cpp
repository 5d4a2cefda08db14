// SPDX-License-Identifier: MIT
#include "app/remembered_campaign.hpp"

#include "app/interrupt.hpp"

namespace app {

verify::Campaign remembered_campaign(const CommonOptions& o, const std::filesystem::path& folder,
                                     Progress& progress, const std::string& what) {
    if (!o.resume) std::filesystem::remove_all(folder);
    verify::Campaign campaign;
    campaign.threads = threads_of(o);
    campaign.remembered_in = folder;
    campaign.stop = &interrupt_flag();
    campaign.progress = [&progress, what](double done, double of, const std::string& ended) {
        progress.show(done, of, ended.empty() ? what : what + ", last finished: " + ended);
    };
    return campaign;
}

}  // namespace app

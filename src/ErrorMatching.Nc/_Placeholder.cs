namespace ErrorMatching.Nc;

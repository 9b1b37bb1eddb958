namespace ErrorMatching.Measurement;

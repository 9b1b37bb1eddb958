namespace ErrorMatching.Mating;

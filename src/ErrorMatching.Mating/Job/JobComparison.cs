namespace ErrorMatching.Mating;

/// <summary>A comparison of counterpart and part in addition to those that every feature has.</summary>
/// <param name="Name">Its name, unique among comparisons and features.</param>
public abstract record JobComparison(string Name);

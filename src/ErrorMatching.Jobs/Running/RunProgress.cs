namespace ErrorMatching.Jobs;

/// <summary>Progress of a run.</summary>
/// <param name="Doing">What is being done, in a few words.</param>
/// <param name="Share">The share done, 0 to 1; null if unknown.</param>
public readonly record struct RunProgress(string Doing, double? Share);

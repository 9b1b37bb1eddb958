namespace ErrorMatching.Hmi;

/// <summary>Something that the station is or stands on.</summary>
/// <param name="What">What it is.</param>
/// <param name="Value">Its version, place or license.</param>
public sealed record AboutRow(string What, string Value);

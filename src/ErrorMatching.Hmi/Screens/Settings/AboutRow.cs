namespace ErrorMatching.Hmi;

/// <summary>Information about the station or one of its components.</summary>
/// <param name="What">Its name.</param>
/// <param name="Value">Its version, place or license.</param>
internal sealed record AboutRow(string What, string Value);

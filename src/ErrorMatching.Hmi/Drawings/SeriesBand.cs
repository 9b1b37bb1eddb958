namespace ErrorMatching.Hmi;

/// <summary>Limits over a range of places in a series.</summary>
/// <param name="First">The first place, from 0.</param>
/// <param name="Last">The last place.</param>
/// <param name="Low">The lower limit.</param>
/// <param name="High">The upper limit.</param>
internal sealed record SeriesBand(int First, int Last, double Low, double High);

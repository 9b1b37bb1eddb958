namespace ErrorMatching.EndToEnd.Tests;

/// <summary>A random counterpart program with features whose nominal and deviated key points are known.
/// The same seed gives the same part.</summary>
/// <param name="Seed">The number that reproduces it.</param>
/// <param name="Flavor">The choices drawn, for the message of a failing test.</param>
/// <param name="Program">The nominal NC program.</param>
/// <param name="ToolRadius">Radius of the tool, mm.</param>
/// <param name="Frame">Part frame to program frame.</param>
/// <param name="Features">The features in order of travel; at least one.</param>
internal sealed record RandomPart(
    int Seed, Flavor Flavor, string Program, double ToolRadius, RandomFrame Frame, IReadOnlyList<RandomFeature> Features)
{
    public IEnumerable<RandomKeyPoint> KeyPoints => Features.SelectMany(f => f.KeyPoints);
}

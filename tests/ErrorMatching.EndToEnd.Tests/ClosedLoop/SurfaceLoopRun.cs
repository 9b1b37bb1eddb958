using ErrorMatching.Freeform;

namespace ErrorMatching.EndToEnd.Tests;

/// <summary>What one machine made of a design.</summary>
/// <param name="Before">Measured after semi-finishing.</param>
/// <param name="After">Measured after finishing.</param>
/// <param name="Expected">What was said before finishing that would be measured after it.</param>
internal sealed record SurfaceLoopRun(DeviationStatistics Before, DeviationStatistics After, SurfacePrediction Expected);

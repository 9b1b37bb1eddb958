using ErrorMatching.Freeform;

namespace ErrorMatching.EndToEnd.Tests;

/// <summary>What one machine made of a design.</summary>
/// <param name="Before">Measured after semi-finishing, by the referee.</param>
/// <param name="After">Measured after finishing, by the referee.</param>
/// <param name="Expected">What was said before finishing that would be measured after it.</param>
internal sealed record SurfaceLoopRun(RefereeFigures Before, RefereeFigures After, SurfacePrediction Expected);

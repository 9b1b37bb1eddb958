namespace ErrorMatching.EndToEnd.Tests;

/// <summary>What a random part is like, apart from its shape.</summary>
/// <param name="Contour">An open run of elements, a closed contour around a boss, or one inside a pocket.</param>
/// <param name="MaterialLeft">Material left of the travel.</param>
/// <param name="Incremental">Features written with G91.</param>
/// <param name="RadiusArcs">Arcs written with R.</param>
/// <param name="Compensated">Programmed on the boundary under G41 or G42.</param>
internal sealed record Flavor(ContourKind Contour, bool MaterialLeft, bool Incremental, bool RadiusArcs, bool Compensated)
{
    /// <summary>The tool's radius. Under cutter compensation the program states the boundary for any tool; a small one fits into every
    /// corner and beside every lead, where a control would stop with a large one.</summary>
    public double ToolOf(double radius) => Compensated ? 0.01 : radius;

    public static Flavor Draw(Random random) =>
        new((ContourKind)random.Next(3), Coin(random), Coin(random), Coin(random), random.Next(3) == 0);

    private static bool Coin(Random random) => random.Next(2) == 0;
}

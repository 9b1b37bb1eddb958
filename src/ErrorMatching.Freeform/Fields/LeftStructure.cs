namespace ErrorMatching.Freeform;

/// <summary>Whether the residuals of a fit have a structure: the fit then misses a part of what was measured.</summary>
internal static class LeftStructure
{
    /// <summary>Probability of noise up to which a structure is believed. Noise must not replace a good fit.</summary>
    private const double Level = 0.003;

    // Each of four tests may have its best rank in another permutation, so that 5 of 2000 is the least probability.
    private const int Permutations = 1999;

    // With fewer permutations, a probability beyond this one ends the test.
    private const double Unlikely = 0.1;
    private const int FewPermutations = 199;

    /// <summary>Root mean square in millimeters below which residuals do not matter: a hundredth of what a probe resolves.</summary>
    private const double Resolved = 1e-5;

    /// <summary>Tests residuals in millimeters.</summary>
    /// <remarks>A fit that follows noise leaves neighbors that are opposite. It misses nothing, and what the other tests find in its
    /// residuals comes from that.</remarks>
    public static bool IsIn(FieldData residuals)
    {
        var few = residuals.Thinned(FieldData.EnoughLines);
        if (few.Count < SpatialStructure.LeastPoints || few.Z.Average(r => r * r) < Resolved * Resolved)
        {
            return false;
        }

        if (Array.TrueForAll(PermutationTest.Run(few, FewPermutations), t => t.P > Unlikely))
        {
            return false;
        }

        var tests = PermutationTest.Run(few, Permutations);
        return Array.Exists(tests, t => t.P <= Level)
            && !Array.Exists(tests, t => t is { Kind: StructureKind.Neighbors, IsOpposite: true, P: <= SpatialStructure.Level });
    }
}

using System.Globalization;

namespace ErrorMatching.Freeform;

/// <summary>What the tests of structure found, in words.</summary>
public static class StructureWords
{
    /// <summary>Whether errors are systematic, and which tests say so: a sentence.</summary>
    public static string Of(SpatialStructure structure)
    {
        ArgumentNullException.ThrowIfNull(structure);
        var least = structure.Tests.Count > 0 ? $" (all tests together: p = {StructureTest.Words(structure.Tests.Min(t => t.P))})" : "";
        return structure.Verdict switch
        {
            SpatialVerdict.Undetermined => "Too few points to tell, or all errors are the same.",
            SpatialVerdict.Noise => $"No: no test finds a structure{least}.",
            _ when structure.Found.Count == 0 => "Yes.",
            _ => $"Yes: {string.Join(", ", structure.Found.Select(Found))}{least}.",
        };
    }

    /// <summary>The name of a test in JSON documents.</summary>
    internal static string Of(StructureKind kind) => kind switch
    {
        StructureKind.Neighbors => "neighbors",
        StructureKind.Plane => "plane",
        StructureKind.Quadratic => "quadratic",
        StructureKind.Scatter => "scatter",
        _ => "wave",
    };

    private static string Found(StructureTest test) => test.Kind switch
    {
        StructureKind.Neighbors => test.IsOpposite ? "neighbors are opposite" : "neighbors are alike",
        StructureKind.Plane => "a plane",
        StructureKind.Quadratic => "a quadratic trend",
        StructureKind.Scatter => "the errors differ by more than the stated uncertainty explains",
        _ => "a wave" + Lengths(test.WaveMm),
    };

    private static string Lengths((double U, double V) waveMm)
    {
        string[] lengths = [.. new[] { (Mm: waveMm.U, Along: "u"), (Mm: waveMm.V, Along: "v") }
            .Where(w => double.IsFinite(w.Mm))
            .Select(w => string.Create(CultureInfo.InvariantCulture, $"{w.Mm:0} mm along {w.Along}"))];
        return lengths.Length == 0 ? "" : " of " + string.Join(" and ", lengths);
    }
}

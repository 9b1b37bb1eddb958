using ErrorMatching.Geometry;

namespace ErrorMatching.Nc.Tests;

/// <summary>What the proof says of a result that was written by hand, to the increment of 0.001 mm.</summary>
internal static class Verdict
{
    /// <summary>Proves a result of a wish for elements.</summary>
    public static NcProof OnElements(string before, string result, params (string Block, double Left)[] wishes)
    {
        var path = Bench.Read(before);
        var elements = wishes.Select(w => ElementWish.AlongNormals(
            path, path.MotionOf(Bench.Blocks(path, w.Block)[0]), w.Left, w.Left, w.Left));
        return Prover.Check(path, NcProgram.FromText(result), DisplacementWish.OfElements([.. elements]), 0.001);
    }

    /// <summary>Proves a result of a wish for elements whose ends go by vectors, and their middles by the mean of both.</summary>
    public static NcProof OnVectors(string before, string result, params (string Block, Vector2 Start, Vector2 End)[] wishes)
    {
        var path = Bench.Read(before);
        var elements = wishes.Select(w => new ElementWish(
            path.MotionOf(Bench.Blocks(path, w.Block)[0]), w.Start, (w.Start + w.End) / 2, w.End));
        return Prover.Check(path, NcProgram.FromText(result), DisplacementWish.OfElements([.. elements]), 0.001);
    }

    /// <summary>The failures of a proof, each behind the number of its line.</summary>
    public static string[] Found(NcProof proof) => [.. proof.Failures.Select(f => $"{f.Place.Line ?? 0} {f.Message}")];

    /// <summary>Proves a result of a wish for end points.</summary>
    public static NcProof OnEnds(string before, string result, string block, Vector3 by)
    {
        var path = Bench.Read(before);
        var wish = Bench.Usable(DisplacementWish.EndsBy(path, Bench.Blocks(path, block), by));
        return Prover.Check(path, NcProgram.FromText(result), wish, 0.001);
    }
}

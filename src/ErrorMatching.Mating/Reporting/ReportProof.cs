using ErrorMatching.Nc;
using ErrorMatching.Reporting;

namespace ErrorMatching.Mating;

/// <summary>The proof of the program that was written.</summary>
/// <param name="Holds">True if the new program moves as wanted and nothing else changed.</param>
/// <param name="Motions">Number of motions compared.</param>
/// <param name="MovedMotions">Number of motions that differ.</param>
/// <param name="Neighbors">Blocks next to the named ones that moved because they touch them, with their roles.</param>
/// <param name="Marker">The inserted comment, or null.</param>
/// <param name="MaxDeviationFromWantedMm">The largest distance of an end point or center from its wanted position.</param>
/// <param name="UntouchedBytesIdentical">True if every byte outside the edits is unchanged.</param>
public sealed record ReportProof(
    bool Holds,
    int Motions,
    int MovedMotions,
    IReadOnlyList<ProofNeighbor> Neighbors,
    string? Marker,
    double MaxDeviationFromWantedMm,
    bool UntouchedBytesIdentical)
{
    /// <summary>Writes it into the open object.</summary>
    internal void Write(ReportWriter w)
    {
        w.Flag("holds", Holds);
        w.Count("motions", Motions);
        w.Count("movedMotions", MovedMotions);
        w.Texts("neighbors", Neighbors.Select(n => n.Block));
        w.List("neighborRoles", Neighbors, n =>
        {
            w.Text("block", n.Block);
            w.Count("line", n.Line);
            w.Text("role", ReportWords.Of(n.Role));
            w.Number("displacementMm", n.DisplacementMm);
        });
        w.Text("marker", Marker);
        w.Number("maxDeviationFromWantedMm", MaxDeviationFromWantedMm);
        w.Flag("untouchedBytesIdentical", UntouchedBytesIdentical);
    }

    /// <summary>Reads the proof of a report. Older reports name the neighbors without roles, or lack the marker; the report of a displaced
    /// surface names no neighbors.</summary>
    /// <exception cref="Refusals.InputException">A member is missing or wrong.</exception>
    public static ReportProof Read(ReportReader proof)
    {
        ArgumentNullException.ThrowIfNull(proof);
        return new(
            proof.Flag("holds"),
            proof.Count("motions"),
            proof.Count("movedMotions"),
            proof.OptionalList("neighborRoles", n => new ProofNeighbor(
                n.Text("block"), n.Count("line"), n.Word<NeighborRole>("role", ReportWords.Of), n.Number("displacementMm"))),
            proof.OptionalText("marker"),
            proof.Number("maxDeviationFromWantedMm"),
            proof.Flag("untouchedBytesIdentical"));
    }
}

using ErrorMatching.Reporting;

namespace ErrorMatching.Mating;

/// <summary>The section with the results of reading the new program again.</summary>
internal static class MatchProof
{
    public static void Write(HtmlText html, MatchReport report)
    {
        var proof = report.Proof;
        WriteVerdict(html, proof);
        (string What, string Found)[] rows =
        [
            ("Motions compared", ReportNumber.Count(proof.Motions)),
            ("Motions that differ", ReportNumber.Count(proof.MovedMotions)),
            ("Largest distance of a motion from where it was wanted", $"{ReportNumber.Fine(proof.MaxDeviationFromWantedMm)} mm"),
            (
                "Neighbors that followed because they touch what moved",
                proof.Neighbors.Count == 0
                    ? "none"
                    : string.Join(
                        "; ",
                        proof.Neighbors.Select(
                            n => $"{n.Block} {ReportWords.Sentence(n.Role)} by {ReportNumber.Fine(n.DisplacementMm)} mm"))),
            ("Every byte outside the changed words is the original one", proof.UntouchedBytesIdentical ? "✓ yes" : "✗ NO"),
            ("Marker comment", proof.Marker ?? "none, since nothing was changed"),
        ];
        HtmlTable.Write(
            html,
            "proof-table",
            "What the comparison of both programs showed",
            [new("Question"), new("Finding")],
            rows,
            (row, r) =>
        {
            row.Header(r.What);
            using (row.Cell("wrap"))
            {
                html.Text(r.Found);
            }
        });
        html.Put(
            "p",
            "The new program was read and interpreted again, and compared with the original motion by motion. Tool radius compensation "
                + "is not applied in the comparison: it is the programmed path that is compared.",
            ("class", "small"));
    }

    /// <summary>Writes whether the proof succeeded, as a mark and words.</summary>
    internal static void WriteVerdict(HtmlText html, ReportProof proof)
    {
        using (html.In("p", ("class", proof.Holds ? "verdict holds" : "verdict fails")))
        {
            html.Put("strong", proof.Holds ? "✓ The proof holds." : "✗ The proof does not hold. Do not use this program.");
            html.Text(
                proof.Holds
                    ? " The new program moves as wanted, and nothing else was changed."
                    : " It does not move as wanted, or something else was changed.");
        }
    }
}

using System.Globalization;
using System.Text.Json;
using ErrorMatching.Mating;
using ErrorMatching.Nc;
using ErrorMatching.Reporting;

namespace ErrorMatching.Console;

/// <summary>A proof in the terms of a match's report.</summary>
internal static class ShownProof
{
    /// <summary>Writes the member <c>proof</c>.</summary>
    public static void Write(Utf8JsonWriter json, NcProof proof)
    {
        json.WriteStartObject("proof");
        json.WriteBoolean("holds", proof.Holds);
        json.WriteNumber("motions", proof.Motions);
        json.WriteNumber("movedMotions", proof.MovedMotions);
        json.WriteStartArray("neighbors");
        foreach (var neighbor in proof.Neighbors)
        {
            json.WriteStringValue(neighbor.Block);
        }

        json.WriteEndArray();
        json.WriteStartArray("neighborRoles");
        foreach (var neighbor in proof.Neighbors)
        {
            json.WriteStartObject();
            json.WriteString("block", neighbor.Block);
            json.WriteNumber("line", neighbor.Line);
            json.WriteString("role", ReportWords.Of(neighbor.Role));
            json.Number("displacementMm", Math.Round(neighbor.DisplacementMm, 9));
            json.WriteEndObject();
        }

        json.WriteEndArray();
        json.WriteString("marker", proof.Marker);
        json.Number("maxDeviationFromWantedMm", Math.Round(proof.MaxDeviationFromWantedMm, 9));
        json.WriteBoolean("untouchedBytesIdentical", proof.UntouchedBytesIdentical);
        json.WriteEndObject();
    }

    /// <summary>Writes a successful proof.</summary>
    public static void Write(Page page, NcProof proof)
    {
        page.Verdict(
            string.Create(
                CultureInfo.InvariantCulture,
                $"Proof holds: of {ReportNumber.Count(proof.Motions, "motion")} {proof.MovedMotions} moved, none further than "
                    + $"{Show.Mm(proof.MaxDeviationFromWantedMm)} mm from where it was wanted; every byte besides is the original's."),
            isGood: true);
        foreach (var neighbor in proof.Neighbors)
        {
            page.Line($"Neighbor {neighbor.Block} {ReportWords.Sentence(neighbor.Role)} by {Show.Mm(neighbor.DisplacementMm)} mm.");
        }
    }
}

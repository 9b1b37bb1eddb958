using System.Text;

namespace ErrorMatching.Mating.Tests;

/// <summary>A job with one feature of each kind, to be broken in one place.</summary>
internal static class SampleJob
{
    public const string Text = """
        {
          "kind": "mating", "name": "Complex mating", "workOrder": "WO-1",
          "part": { "theoretical": "theoretical.csv", "measured": "part.csv" },
          "gauge": { "format": "points", "uncertaintyMm": 0.002 },
          "alignment": { "kind": "none" },
          "features": [
            { "name": "L1", "kind": "line", "points": ["1", "2"], "blocks": ["N100"], "toleranceMm": [-0.05, 0.05] },
            { "name": "L2L3", "kind": "triangle", "points": [["2a", "3a"], ["3b", "4"]], "blocks": ["N110..N130"], "toleranceMm": [-0.04, 0.06] },
            { "name": "C1", "kind": "curve", "points": ["5..14"], "blocks": ["/^N8[0-9]{3}\\b/"], "toleranceMm": [-0.05, 0.05] }
          ],
          "counterpart": {
            "program": "counterpart.nc", "dialect": "delta-nc300", "toolDiameterMm": 6,
            "frame": { "mirror": "none", "rotateDeg": 0, "translateMm": [-80, 0] }
          },
          "compensation": { "from": "part" }
        }
        """;

    /// <summary>The job after some replacements, each "found => put instead"; each must be found.</summary>
    public static MatingJob With(params (string Found, string Instead)[] replacements) =>
        MatingJob.Parse(Encoding.UTF8.GetBytes(TextWith(replacements)), "folder/job.json");

    private static string TextWith((string Found, string Instead)[] replacements)
    {
        var text = Text;
        foreach (var (found, instead) in replacements)
        {
            Assert.Contains(found, text, StringComparison.Ordinal);
            text = text.Replace(found, instead, StringComparison.Ordinal);
        }

        return text;
    }
}

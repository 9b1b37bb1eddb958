using ErrorMatching.Nc;

namespace ErrorMatching.Freeform.Tests;

/// <summary>Plans as a job would ask for them.</summary>
internal static class Plans
{
    public static JobTool Ball(double diameter) => new(diameter, 2, 10_000, 1200);

    public static JobToolpath Passes(
        double scallop = 0.001, double chord = 0.001, bool alongU = true, bool zigzag = true, bool tip = false) =>
        new()
        {
            AlongU = alongU,
            Zigzag = zigzag,
            ScallopMm = scallop,
            ChordMm = chord,
            ClearanceMm = 10,
            ProgramsTip = tip,
            Dialect = "linuxcnc",
        };

    public static ToolPathResult Of(
        PartSurface surface, JobToolpath toolpath, double diameter = 6, double stock = 0, NcDialect? dialect = null) =>
        ToolPathPlanner.Plan(surface, Ball(diameter), toolpath, stock, dialect ?? NcDialects.LinuxCnc);

    public static ToolPath Path(PartSurface surface, JobToolpath toolpath, double diameter = 6, double stock = 0, NcDialect? dialect = null)
    {
        var result = Of(surface, toolpath, diameter, stock, dialect);
        Assert.True(result.IsUsable, result.Refusal?.Message);
        return result.Path;
    }

    /// <summary>What is wrong with a program, but for the alarm by which it stops where no tool is named.</summary>
    public static IEnumerable<NcProblem> Faults(NcPath read) => read.Problems.Where(
        p => p.Code != NcRefusalCodes.RefusedByControl || read.Program.TextOf(read.Program[p.Block]).TrimEnd() != "T-1 M6");

    public static FreeformJob Job(JobToolpath toolpath, string dialect, string name = "Surface one") => FreeformJob.Parse(
        System.Text.Encoding.UTF8.GetBytes(
            $$"""
            { "kind": "freeform", "name": "{{name}}", "surface": "surface.igs", "tool": { "kind": "ball", "diameterMm": 6, "flutes": 2 }, "spindleRpm": 10000, "feedMmPerMin": 1200,
              "measuring": { "curves": 7, "pointsPerCurve": 10, "stylusDiameterMm": 6, "dialect": "siemens-840d" },
              "toolpath": { "dialect": "{{dialect}}", "programs": "{{(toolpath.ProgramsTip ? "tip" : "center")}}" } }
            """),
        "job.json");
}

using ErrorMatching.Geometry;
using ErrorMatching.Reporting;

namespace ErrorMatching.Freeform;

/// <summary>The verdict on a compensation that a setter decides by: the surface as measured, and as it is expected after the
/// compensation.</summary>
/// <param name="Tolerance">The tolerance.</param>
/// <param name="Before">The surface as measured.</param>
/// <param name="Predicted">The surface as expected.</param>
public sealed record SurfaceVerdict(ProfileTolerance Tolerance, ProfileJudgement Before, ProfileJudgement Predicted)
{
    /// <summary>True if it says to cut; false if somebody has to decide first.</summary>
    public bool IsToCut => Predicted.IsWithin;

    /// <summary>Writes it into the open object.</summary>
    internal void Write(ReportWriter json)
    {
        json.Text("code", ProfileWords.Of(Predicted.Code));
        json.Flag("cut", IsToCut);
        json.Flag("inTolerance", Predicted.IsWithin);
        Write(json, Tolerance);
        json.Object("before", () => Before.Write(json));
        json.Object("predicted", () => Predicted.Write(json));
        json.Text("sentence", ProfileWords.Of(this));
    }

    /// <summary>Reads what <see cref="Write(ReportWriter)"/> writes.</summary>
    internal static SurfaceVerdict Read(ReportReader json)
    {
        var risk = json.OptionalNumber("riskPercent");
        if (risk is < 0.01 or > 50)
        {
            throw json.Refusal("riskPercent", "out-of-range", "a number from 0.01 to 50");
        }

        return new(
            new(
                json.Micrometers("toleranceUm"),
                risk is { } percent ? DecisionRule.GuardBand(percent) : DecisionRule.Simple,
                json.Word("alignment", [true, false], Alignment)),
            ProfileJudgement.Read(json.Object("before")),
            ProfileJudgement.Read(json.Object("predicted")));
    }

    /// <summary>Writes a tolerance into the open object.</summary>
    internal static void Write(ReportWriter json, ProfileTolerance tolerance)
    {
        json.Number("toleranceUm", tolerance.WidthMm * 1000);
        json.Text("alignment", Alignment(tolerance.IsAligned));
        json.Text("rule", tolerance.Rule.IsGuarded ? "guard-band" : "simple");
        json.Number("riskPercent", tolerance.Rule.RiskPercent);
    }

    private static string Alignment(bool isAligned) => isAligned ? "best-fit" : "none";
}

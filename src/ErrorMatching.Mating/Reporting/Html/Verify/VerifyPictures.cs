using ErrorMatching.Reporting;

namespace ErrorMatching.Mating;

/// <summary>Plot and drawings of a verification: both counterparts as measured, against the measured part.</summary>
internal static class VerifyPictures
{
    public static void Write(HtmlText html, VerifyReport report)
    {
        var result = report.Result;
        PlotPoint[] plot = [.. result.Points.Select(p => new PlotPoint(p.Label, "", p.BeforeError.NormalMm, p.AfterError.NormalMm, null))];
        var drawn = DrawnFeature.Of(
            [],
            [.. result.Points.Select(p => new DrawnPoint(p.Label, p.Part, p.Normal, 0, p.BeforeError.NormalMm, p.AfterError.NormalMm))]);
        ReportPictures.Write(
            html,
            plot,
            AssemblyScene.Of([drawn]),
            report.IsBeforeMeasured ? "without compensation (measured)" : "without compensation (as designed)",
            "with compensation (measured)");
    }
}

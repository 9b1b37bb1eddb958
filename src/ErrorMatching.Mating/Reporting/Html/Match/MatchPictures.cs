using ErrorMatching.Reporting;

namespace ErrorMatching.Mating;

/// <summary>Plot and drawings of a match: the mating error without compensation, and the predicted one with it.</summary>
internal static class MatchPictures
{
    public static void Write(HtmlText html, MatchReport report) =>
        ReportPictures.Write(
            html,
            Plot(report),
            AssemblyScene.Of(report.Features.Select(f => Draw(report, f))),
            "without compensation",
            "as compensated (predicted)");

    private static PlotPoint[] Plot(MatchReport report)
    {
        var limits = report.Features.ToDictionary(f => f.Name, f => f.Tolerance.Band.OfMatingError, StringComparer.Ordinal);
        return [
            .. report.KeyPoints.Select(p => new PlotPoint(
                p.Point, p.Feature, p.UncompensatedMm, p.PredictedMm, limits.TryGetValue(p.Feature, out var band) ? band : null))];
    }

    private static DrawnFeature? Draw(MatchReport report, ReportFeature feature) => DrawnFeature.Of(
        feature.TheoreticalOutline,
        [
            .. report.PointsOf(feature).Select(p => new DrawnPoint(
                p.Point, p.Theoretical, p.Normal, p.NormalMm, p.NormalMm + p.UncompensatedMm, p.NormalMm + p.PredictedMm))]);
}

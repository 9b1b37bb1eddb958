using ErrorMatching.Geometry;
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
            "as compensated (predicted)",
            [.. report.Features.Select(f => Between(report, f)).OfType<PlotPlace>()]);

    private static PlotPoint[] Plot(MatchReport report)
    {
        var limits = report.Features.ToDictionary(f => f.Name, f => f.Tolerance.Band.Opposite(), StringComparer.Ordinal);
        return [
            .. report.KeyPoints.Select(p => new PlotPoint(
                p.Point, p.Feature, p.UncompensatedMm, p.PredictedMm, limits.TryGetValue(p.Feature, out var band) ? band : null)
            {
                Interval95Mm = p.Interval95Mm
            })];
    }

    // The place on the axis of the points, at its share of the way from one key point to the next.
    private static PlotPlace? Between(MatchReport report, ReportFeature feature)
    {
        if (ErrorLeft.Between(feature) is not { IsKnown: true } worst)
        {
            return null;
        }

        var (points, last, nearest, place) = (report.KeyPoints, -1, double.PositiveInfinity, double.NaN);
        for (var i = 0; i < points.Count; i++)
        {
            if (points[i].Feature != feature.Name)
            {
                continue;
            }

            if (last >= 0)
            {
                var way = new Segment2(points[last].Theoretical, points[i].Theoretical);
                var fraction = way.NearestFraction(worst.Place);
                var distance = way.At(fraction).DistanceTo(worst.Place);
                (nearest, place) = distance < nearest ? (distance, last + fraction) : (nearest, place);
            }

            last = i;
        }

        return double.IsNaN(place)
            ? null
            : new(feature.Name, place, worst.MatingErrorMm, worst.Interval95Mm ?? 0, VerdictWords.Place(worst));
    }

    private static DrawnFeature? Draw(MatchReport report, ReportFeature feature) => DrawnFeature.Of(
        feature.TheoreticalOutline,
        [
            .. report.PointsOf(feature).Select(p => new DrawnPoint(
                p.Point, p.Theoretical, p.Normal, p.NormalMm, p.NormalMm + p.UncompensatedMm, p.NormalMm + p.PredictedMm)
            {
                Interval95Mm = p.Interval95Mm
            })]);
}

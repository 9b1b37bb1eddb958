using ErrorMatching.Reporting;

namespace ErrorMatching.Mating;

/// <summary>What the measured points say about each other, before a correction is made of them.</summary>
/// <param name="Suspects">The points that do not fit the others, the furthest off first.</param>
/// <param name="Unchecked">Names of the features whose points are too few to contradict each other.</param>
/// <param name="Motion">The motion of the part as a whole that explains the most of what was measured; null if no motion can be told
/// from the points.</param>
/// <param name="Scatter">The scatter of the points beside the stated uncertainty; null if the points do not tell.</param>
public sealed record MeasurementTrust(
    IReadOnlyList<SuspectPoint> Suspects, IReadOnlyList<string> Unchecked, CommonMotion? Motion, ScatterRatio? Scatter)
{
    /// <summary>Writes what the verdict states of it into the open object.</summary>
    internal void Write(ReportWriter w)
    {
        w.List("suspectPoints", Suspects, s => s.Write(w));
        w.Texts("uncheckedFeatures", Unchecked);
        w.Optional("commonMotion", Motion, m => m.Write(w));
        w.Optional("statedUncertaintyRatio", Scatter, s => s.Write(w));
    }

    /// <summary>Reads what <see cref="Write"/> writes; null in reports of earlier versions.</summary>
    internal static MeasurementTrust? Read(ReportReader r) => !r.Names.Contains("suspectPoints") ? null : new(
        r.List("suspectPoints", SuspectPoint.Read),
        r.Texts("uncheckedFeatures"),
        r.OptionalObject("commonMotion") is { } motion ? CommonMotion.Read(motion) : null,
        r.OptionalObject("statedUncertaintyRatio") is { } scatter ? ScatterRatio.Read(scatter) : null);

    /// <summary>Compares the points with each other.</summary>
    /// <param name="job">The job.</param>
    /// <param name="runs">The runs that cut its features, with their key points.</param>
    /// <param name="decision">The deviations of the points.</param>
    internal static MeasurementTrust Judge(MatingJob job, IReadOnlyList<RunEstimate> runs, MatingDecision decision)
    {
        var u = decision.Features[0].StandardUncertaintyMm;
        var suspects = new List<SuspectPoint>();
        var judged = new HashSet<int>();
        foreach (var run in runs)
        {
            var (rows, points) = run.MeasuredRows();
            if (rows.Length < SuspectSearch.Fewest)
            {
                continue;
            }

            judged.UnionWith(points.Select(p => p.Feature));
            var found = run.Stretches.Count > 0
                ? SuspectSearch.AlongCourse(run.Stretches, rows, u)
                : SuspectSearch.AroundShape(points, [.. rows.Select(r => r.ValueMm)], u);
            suspects.AddRange(found.Select(s => new SuspectPoint(
                job.Features[points[s.Row].Feature].Points[points[s.Row].Index],
                job.Features[points[s.Row].Feature].Name,
                s.OffMm,
                s.Sigmas)));
        }

        return new(
            [.. suspects.OrderByDescending(s => Math.Abs(s.Sigmas))],
            [.. job.Features.Where((_, f) => !judged.Contains(f)).Select(f => f.Name)],
            CommonMotion.Find(
                [.. decision.Features.SelectMany(f => f.Points).Select(p => p.Point)],
                u,
                job.CommonMotionMm ?? LargestLimit(job)),
            ScatterRatio.Estimate([.. runs.Select(r => (r.Stretches, r.MeasuredRows().Rows))], u));
    }

    // A job that may correct by the work offset expects parts that are shifted.
    private static double? LargestLimit(MatingJob job) => job.Correction.Allows(CorrectionKind.WorkOffset) ? null
        : job.Features.Max(f => Math.Max(-f.Tolerance.Band.LowerMm, f.Tolerance.Band.UpperMm));
}

/// <summary>A key point that does not fit the others of its run.</summary>
/// <param name="Point">Its label.</param>
/// <param name="Feature">Its feature.</param>
/// <param name="StandsOutMm">How far it is off what the others say, along the normal to the tool.</param>
/// <param name="Sigmas">The same in standard deviations of what the others say.</param>
public sealed record SuspectPoint(string Point, string Feature, double StandsOutMm, double Sigmas)
{
    internal void Write(ReportWriter w)
    {
        w.Text("point", Point);
        w.Text("feature", Feature);
        w.Number("standsOutMm", StandsOutMm);
        w.Number("z", Sigmas);
    }

    internal static SuspectPoint Read(ReportReader r) => new(r.Text("point"), r.Text("feature"), r.Number("standsOutMm"), r.Number("z"));
}

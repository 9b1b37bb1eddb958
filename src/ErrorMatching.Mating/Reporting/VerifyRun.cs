using ErrorMatching.Geometry;
using ErrorMatching.Json;
using ErrorMatching.Nc;
using ErrorMatching.Refusals;
using ErrorMatching.Reporting;

namespace ErrorMatching.Mating;

/// <summary>Compares two measured counterparts with the part: takes normals from the program, aligns points as the job requests, then
/// runs <see cref="Verifier"/>.</summary>
public static class VerifyRun
{
    private const string BeforeAsDesigned = "No counterpart that was cut without compensation is measured: before is the counterpart as "
        + "designed, which no machine cuts exactly.";

    /// <summary>Creates the report of a verification.</summary>
    /// <param name="input">The input.</param>
    /// <param name="refusals">Why nothing can be compared: an origin outside its limit, points in another unit, or features not on the
    /// program; empty if there is a report.</param>
    /// <exception cref="InputException">A measurement lacks a point or coordinate.</exception>
    /// <exception cref="GeometryException">The points of a feature do not determine it; the message names it.</exception>
    /// <exception cref="InputException">The dialect or a selector cannot be read.</exception>
    public static VerifyReport? Report(VerifyInput input, out IReadOnlyList<Refusal> refusals)
    {
        ArgumentNullException.ThrowIfNull(input);
        var job = input.Job;
        var path = NcInterpreter.Run(
            NcProgram.Read(input.Program), job.Counterpart.DialectOf(input.OwnDialect), input.Library, CancellationToken.None);
        IReadOnlyList<FeatureMap> maps = [];
        var refused = path.Refusal
            ?? UnitCheck.Refuse(job, input.Theoretical, input.Part, input.Before, input.After)
            ?? ColumnCheck.Refuse(job, input.Theoretical, input.Part, input.Before, input.After)
            ?? OriginCheck.Refuse(job.OriginCheck, input.Theoretical, input.Part, input.Before, input.After)
            ?? AlignedMeasurement.Check(job)
            ?? FeatureMapper.Map(job, path, input.Theoretical, out maps);
        if (refused is { } refusal)
        {
            refusals = [refusal];
            return null;
        }

        refusals = [];
        var part = AlignedMeasurement.Align(job, maps, input.Theoretical, input.Part, MeasuredPiece.Part);
        var before = input.Before is null
            ? null
            : AlignedMeasurement.Align(job, maps, input.Theoretical, input.Before, MeasuredPiece.Counterpart);
        var after = AlignedMeasurement.Align(job, maps, input.Theoretical, input.After, MeasuredPiece.Counterpart);
        var boundaries = maps.Select(m => Boundary(input, path, m)).ToArray();
        var points = maps.Zip(boundaries).Select(m => (IReadOnlyList<VerifiedPoint>)
            [
                .. m.Second.Points.Select(
                    (p, i) => new VerifiedPoint(
                        p.Label,
                        part.Points[p.Label],
                        before?.Points[p.Label] ?? p.Theoretical,
                        after.Points[p.Label],
                        m.First.Normals[i])
                    {
                        GapMm = m.First.Feature.GapMm,
                    })]);
        ReportInput[] inputs =
        [
            new("theoretical", input.Theoretical.File, input.Theoretical.Sha256),
            new("part", input.Part.File, input.Part.Sha256),
            .. input.Before is { } measured ? [new ReportInput("counterpart", measured.File, measured.Sha256)] : Array.Empty<ReportInput>(),
            new("counterpart-after", input.After.File, input.After.Sha256),
            new("program", input.ProgramFile, ContentHash.Sha256(input.Program.Span)),
            .. path.Dialect.Files.Select(f => new ReportInput("dialect", f.File, f.Sha256)),
        ];
        return new(
            new ReportJob(job.Name, job.WorkOrder, job.File, job.Sha256),
            inputs,
            Verifier.Verify(job, [.. points], input.Before is not null) with { Boundaries = boundaries },
            input.Before is null ? [BeforeAsDesigned] : [])
        {
            IsBeforeMeasured = input.Before is not null,
            UncertaintyMm = job.Gauge.Uncertainty.CombinedMm * Math.Sqrt(2),
            Rule = job.Rule,
            Pair = Pair(input, path, maps, part, after),
        };
    }

    // What the part differs from the measured counterpart, as in feedback: the boundary of the counterpart is that of its program, and the
    // differences are the part's.
    private static PairAssembly? Pair(
        VerifyInput input, NcPath path, IReadOnlyList<FeatureMap> maps, AlignedMeasurement part, AlignedMeasurement after)
    {
        var job = input.Job with
        {
            Compensation = input.Job.Compensation with { From = CompensationSource.Counterpart }
        };
        var points = maps.Select(map => (IReadOnlyList<BoundaryPoint>)[.. map.Feature.Points.Select((label, i) =>
            new BoundaryPoint(label, after.Points[label], part.Points[label] - (map.Feature.GapMm * map.Normals[i]), map.Normals[i])
            {
                GapMm = map.Feature.GapMm,
            })]).ToArray();
        var runs = new BoundaryRuns(job, path, maps, input.Theoretical);
        var piece = new CourseEstimator(runs, Decider.Decide(job, points)).Measure();
        return PairEstimator.Estimate(job, path, maps, piece, r => r.Run.On(path));
    }

    private static VerifiedBoundary Boundary(VerifyInput input, NcPath path, FeatureMap map)
    {
        var feature = map.Feature;
        return new(
            feature.Name,
            feature.Tolerance.Band,
            [.. feature.Points.Select(l => (l, ProjectedPoint.Of(input.Theoretical[l], feature.Plane, input.Theoretical.File).Position))],
            Outlines.Boundary(input.Job.Counterpart, path, map.Passes[0]));
    }
}

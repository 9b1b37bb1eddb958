using ErrorMatching.Geometry;
using ErrorMatching.Refusals;
using ErrorMatching.Reporting;

namespace ErrorMatching.Freeform;

/// <summary>Evaluation of one or more measured pieces of a design, individually and combined.</summary>
/// <param name="Pieces">The pieces, at least one: replicas of one design.</param>
/// <param name="Together">All errors combined, as in table 3 of Lee 2019.</param>
public sealed record SurfaceEvaluation(IReadOnlyList<EvaluatedPiece> Pieces, DeviationStatistics Together)
{
    /// <summary>Range of the pieces' standard deviations (largest - smallest) in mm: their repeatability (table 2 of Lee 2019).</summary>
    public double RangeOfStandardDeviationsMm =>
        Pieces.Max(p => p.Statistics.StandardDeviationMm) - Pieces.Min(p => p.Statistics.StandardDeviationMm);

    /// <summary>Evaluates pieces.</summary>
    /// <param name="job">Stock, stage and alignment.</param>
    /// <param name="surface">The nominal surface.</param>
    /// <param name="pieces">At least one.</param>
    /// <exception cref="InputException">Two pieces are the same measurement (<c>same-measurement</c>); otherwise as for
    /// <see cref="SurfaceErrors.Find"/> and <see cref="SurfaceAlignment.BestFit"/>.</exception>
    public static SurfaceEvaluation Evaluate(FreeformJob job, PartSurface surface, IReadOnlyList<MeasuredPoints> pieces)
    {
        ArgumentNullException.ThrowIfNull(job);
        ArgumentNullException.ThrowIfNull(pieces);
        MeasuredPoints.ThrowIfTwice(pieces);
        EvaluatedPiece[] evaluated = [.. pieces.Select(p => Evaluate(job, surface, p))];
        for (var k = 1; k < evaluated.Length; k++)
        {
            if (evaluated[k].Stage != evaluated[0].Stage)
            {
                evaluated[k] = evaluated[k] with
                {
                    Warnings = [
                        .. evaluated[k].Warnings,
                        ReportWarning.Of(
                            SurfaceWarningForms.OtherStages,
                            evaluated[k].File,
                            MeasuredStage.Name(evaluated[k].Stage),
                            evaluated[0].File,
                            MeasuredStage.Name(evaluated[0].Stage))],
                };
            }
        }

        return new(evaluated, DeviationStatistics.Of([.. evaluated.SelectMany(p => p.Samples).Select(s => s.ErrorMm)]));
    }

    private static EvaluatedPiece Evaluate(FreeformJob job, PartSurface surface, MeasuredPoints piece)
    {
        var distances = SurfaceErrors.Find(surface, Contacts(piece), 0, piece.File);
        var stage = MeasuredStage.Of(job, distances.Sum(d => d.ErrorMm) / distances.Count);
        var stock = job.Stock.Of(stage);
        if (!job.Measuring.BestFit)
        {
            return Piece(piece, stage, job, null, [.. distances.Select(d => d with { ErrorMm = d.ErrorMm - stock })]);
        }

        var alignment = SurfaceAlignment.BestFit(surface, [.. Contacts(piece)], stock, piece.File);
        return Piece(
            piece,
            stage,
            job,
            alignment,
            SurfaceErrors.Find(surface, Contacts(piece).Select(p => (p.Plan, alignment.Apply(p.Contact))), stock, piece.File));
    }

    private static EvaluatedPiece Piece(
        MeasuredPoints piece, CuttingStage stage, FreeformJob job, SurfaceAlignment? alignment, IReadOnlyList<ErrorSample> samples) =>
        new(
            piece.File,
            piece.Sha256,
            stage,
            stage != job.Measuring.After,
            alignment,
            samples,
            DeviationStatistics.Of([.. samples.Select(s => s.ErrorMm)]),
            [.. piece.Warnings, .. Outlying(piece, samples, job.Measuring.UncertaintyMm)])
        {
            Judgement = job.Profile is { } tolerance
                ? ProfileJudgement.OfMeasured(tolerance, samples, job.Measuring.UncertaintyMm)
                : null,
        };

    // A piece is judged by all its points, but a chip under the stylus is not part of the piece, so outlying points are reported.
    private static IEnumerable<ReportWarning> Outlying(
        MeasuredPoints piece, IReadOnlyList<ErrorSample> samples, double uncertaintyMm)
    {
        var points = OutlyingPoints.Find(samples, uncertaintyMm);
        if (points.Count == 0)
        {
            return [];
        }

        var (furthest, others) = OutlyingPoint.Values(points);
        return [
            others.Length == 0
                ? ReportWarning.Of(SurfaceWarningForms.PointOff, [piece.File, .. furthest])
                : ReportWarning.Of(SurfaceWarningForms.PointsOff, [piece.File, .. furthest, others])];
    }

    private static IEnumerable<(PlanPoint Plan, Point3 Contact)> Contacts(MeasuredPoints piece) =>
        piece.Points.Select(p => (p.Planned, p.Contact));
}

using ErrorMatching.Geometry;

namespace ErrorMatching.Mating;

/// <summary>The boundary of the measured piece itself, with its uncertainty: what a program leaves of it, and with which probability a
/// pair goes together, follow from it.</summary>
internal sealed class PieceEstimate
{
    // The risk that an error anywhere along the boundary is beyond the bounds of its features.
    private const double BoundRisk = 0.05;

    private readonly BoundaryRuns _runs;
    private readonly bool _tellsForm;

    /// <summary>Takes it from the estimates of all runs.</summary>
    /// <param name="runs">The runs of cuts.</param>
    /// <param name="estimates">The estimate of each.</param>
    public PieceEstimate(BoundaryRuns runs, IReadOnlyList<RunEstimate> estimates)
    {
        (_runs, Runs) = (runs, estimates);
        _tellsForm = runs.Maps.SelectMany(m => m.Passes).SelectMany(runs.ElementsOf).Any(e => e.OwnPoints > e.PointsOfShape);
    }

    /// <summary>The estimates of its runs.</summary>
    public IReadOnlyList<RunEstimate> Runs { get; }

    /// <summary>The places at which ways of cutting are compared.</summary>
    public IReadOnlyList<ComparedPlace> Places() => [.. Runs.SelectMany(r => r.Places(_runs.FeatureOf))];

    /// <summary>Predicts the mating error that cuts leave.</summary>
    /// <param name="cuts">The cuts of each run.</param>
    public MatingPrediction PredictOn(Func<RunEstimate, RunPath> cuts)
    {
        var toPart = _runs.Job.Counterpart.Frame.Inverse();
        return new([.. _runs.Maps.Select((map, f) => Predict(map, f, cuts, toPart))]);
    }

    /// <summary>Names of the features of whose form between the key points nothing is known. What a neighbor takes away has none.</summary>
    public IReadOnlyList<string> UnknownForms() => [
        .. _runs.Maps.Where((map, f) => RunOf(map, f) is var run && _runs.ElementsOf(map.Passes[0]) is var elements
            && (elements.Count == 0
                ? !WholeShape.Around(run, _runs.Path, map.Passes[0]).Knows(map.Feature.FormMm)
                : elements.Any(e => !TellsForm(e) && run.IsCompared(e)))).Select(m => m.Feature.Name)];

    private FeaturePrediction Predict(FeatureMap map, int feature, Func<RunEstimate, RunPath> cuts, RigidTransform2 toPart)
    {
        var (pass, points) = (map.Passes[0], new PredictedError[map.Feature.Points.Count]);
        var run = RunOf(map, feature);
        var (elements, cutsBefore, cutsAfter) = (_runs.ElementsOf(pass), run.Run.On(_runs.Path), cuts(run));
        for (var p = 0; p < run.Points.Count; p++)
        {
            if (run.Points[p] is var point && point.Feature == feature)
            {
                points[point.Index] = new(
                    toPart.Apply(point.Theoretical),
                    toPart.Apply(point.Normal),
                    run.ErrorAt(p, cutsBefore),
                    run.ErrorAt(p, cutsAfter),
                    run.UncertaintyMm)
                {
                    BaseMm = point.BaseMm,
                };
            }
        }

        var limits = map.Feature.Tolerance.Band is { WidthMm: > 0 } band ? band.Opposite() : null;
        var worst = elements.Count == 0
            ? WholeShape.Around(run, _runs.Path, pass).WorstOn(cutsBefore, cutsAfter, map.Feature.FormMm, limits, Risk)
            : PredictedError.Worst(
                elements.Where(e => !IsKnown(e, run)).Select(e => run.WidestGap(e, cutsAfter))
                    .Append(run.WorstAlong([.. elements.Where(e => IsKnown(e, run))], cutsAfter, limits, Risk))
                    .OfType<PredictedError>(),
                limits);

        return new(
            points,
            worst is null ? null : worst with { Place = toPart.Apply(worst.Place), Normal = toPart.Apply(worst.Normal) },
            [.. elements.Select(run.PriorOf)])
        {
            Deviation = elements.Count == 0 ? null : along => run.DeviationAt(
                elements.MinBy(e => Math.Max(0, Math.Max(e.FromMm - along, along - e.ToMm)))!, along),
        };
    }

    private RunEstimate RunOf(FeatureMap map, int feature) =>
        Runs.First(r => r.Run.Contains(map.Passes[0]) && r.Points.Any(p => p.Feature == feature));

    private bool IsKnown(BoundaryElement element, RunEstimate run) => TellsForm(element) && run.IsCompared(element);

    // With as many points as its shape needs, an element does not tell its form. Another one of the job may tell how large such errors are.
    private bool TellsForm(BoundaryElement element) =>
        element.FormMm is not null || element.OwnPoints > element.PointsOfShape || _tellsForm;

    // The bounds of all features together hold with 95 %.
    private double Risk => 1 - Elementary.Pow(1 - BoundRisk, 1.0 / _runs.Maps.Count);
}

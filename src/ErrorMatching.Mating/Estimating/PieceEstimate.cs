using ErrorMatching.Geometry;
using ErrorMatching.Nc;

namespace ErrorMatching.Mating;

/// <summary>The boundary of the measured piece itself, with its uncertainty: what a program leaves of it, and with which probability a
/// pair goes together, follow from it.</summary>
internal sealed class PieceEstimate
{
    // The risk that an error anywhere along the boundary is beyond the bounds of its features.
    private const double BoundRisk = 0.05;

    private readonly MatingJob _job;
    private readonly NcPath _path;
    private readonly IReadOnlyList<FeatureMap> _maps;
    private readonly IReadOnlyDictionary<FeaturePass, List<BoundaryElement>> _elements;
    private readonly bool _tellsForm;

    /// <summary>Takes it from runs that are solved for it.</summary>
    /// <param name="job">The job.</param>
    /// <param name="path">The counterpart's program, interpreted.</param>
    /// <param name="maps">The features mapped onto it, in the order of the job.</param>
    /// <param name="runs">The runs of cuts.</param>
    /// <param name="elements">The elements of each pass.</param>
    public PieceEstimate(
        MatingJob job,
        NcPath path,
        IReadOnlyList<FeatureMap> maps,
        IReadOnlyList<RunEstimate> runs,
        IReadOnlyDictionary<FeaturePass, List<BoundaryElement>> elements)
    {
        (_job, _path, _maps, Runs, _elements) = (job, path, maps, runs, elements);
        _tellsForm = elements.Values.Any(list => list.Exists(e => e.OwnPoints > e.PointsOfShape));
    }

    /// <summary>The runs of cuts that are estimated.</summary>
    public IReadOnlyList<RunEstimate> Runs { get; }

    /// <summary>The places at which ways of cutting are compared.</summary>
    public IReadOnlyList<ComparedPlace> Places() => [.. Runs.SelectMany(r => r.Places(FeatureOf))];

    private int FeatureOf(BoundaryElement element)
    {
        var feature = 0;
        while (!_maps[feature].Passes.Contains(element.Pass))
        {
            feature++;
        }

        return feature;
    }

    /// <summary>Predicts the mating error that cuts leave.</summary>
    /// <param name="cuts">The cuts of each run.</param>
    public MatingPrediction PredictOn(Func<RunEstimate, RunPath> cuts)
    {
        var toPart = _job.Counterpart.Frame.Inverse();
        return new([.. _maps.Select((map, f) => Predict(map, f, cuts, toPart))]);
    }

    /// <summary>Names of the features of whose form between the key points nothing is known. What a neighbor takes away has none.</summary>
    public IReadOnlyList<string> UnknownForms() => [
        .. _maps.Where((map, f) => RunOf(map, f) is var run && (_elements[map.Passes[0]].Count == 0
            ? !WholeShape.Around(run, _path, map.Passes[0]).Knows(map.Feature.FormMm)
            : !_elements[map.Passes[0]].TrueForAll(e => TellsForm(e) || !run.IsCompared(e)))).Select(m => m.Feature.Name)];

    private FeaturePrediction Predict(FeatureMap map, int feature, Func<RunEstimate, RunPath> cuts, RigidTransform2 toPart)
    {
        var (pass, points) = (map.Passes[0], new PredictedError[map.Feature.Points.Count]);
        var run = RunOf(map, feature);
        var (cutsBefore, cutsAfter) = (run.OnCuts(_path), cuts(run));
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
                    BaseMm = run.BaseMm(p),
                };
            }
        }

        var limits = map.Feature.Tolerance.Band is { WidthMm: > 0 } band ? band.Opposite() : null;
        var worst = _elements[pass].Count == 0
            ? WholeShape.Around(run, _path, pass).WorstOn(cutsBefore, cutsAfter, map.Feature.FormMm, limits, Risk)
            : PredictedError.Worst(
                _elements[pass].Where(e => !IsKnown(e, run)).Select(e => run.WidestGap(e, cutsAfter))
                    .Append(run.WorstAlong(_elements[pass].FindAll(e => IsKnown(e, run)), cutsAfter, limits, Risk))
                    .OfType<PredictedError>(),
                limits);

        return new(
            points,
            worst is null ? null : worst with { Place = toPart.Apply(worst.Place), Normal = toPart.Apply(worst.Normal) },
            [.. _elements[pass].Select(run.PriorOf)])
        {
            Deviation = _elements[pass].Count == 0 ? null : along => run.DeviationAt(
                _elements[pass].MinBy(e => Math.Max(0, Math.Max(e.FromMm - along, along - e.ToMm)))!, along),
        };
    }

    private RunEstimate RunOf(FeatureMap map, int feature) =>
        Runs.First(r => r.Run.Contains(map.Passes[0]) && r.Points.Any(p => p.Feature == feature));

    private bool IsKnown(BoundaryElement element, RunEstimate run) => TellsForm(element) && run.IsCompared(element);

    // With as many points as its shape needs, an element does not tell its form. Another one of the job may tell how large such errors are.
    private bool TellsForm(BoundaryElement element) =>
        element.FormMm is not null || element.OwnPoints > element.PointsOfShape || _tellsForm;

    // The bounds of all features together hold with 95 %.
    private double Risk => 1 - Elementary.Pow(1 - BoundRisk, 1.0 / _maps.Count);
}

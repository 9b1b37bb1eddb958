using ErrorMatching.Geometry;
using ErrorMatching.Nc;

namespace ErrorMatching.Mating;

/// <summary>Puts the part, as it was estimated, into the counterpart that a program will cut.</summary>
internal sealed class PairEstimator
{
    // Of a longer boundary every second place, or every third, is compared: the time of a match must not grow with it.
    private const int MostPlaces = 500;

    // Normals that differ by less are one direction.
    private const double SameDirection = 1e-6;

    private readonly MatingJob _job;
    private readonly NcPath _path;
    private readonly IReadOnlyList<FeatureMap> _maps;
    private readonly RigidTransform2 _toPart;
    private readonly List<PairPlace> _places = [];
    private readonly List<JointFactor> _factors = [];

    private PairEstimator(MatingJob job, NcPath path, IReadOnlyList<FeatureMap> maps) =>
        (_job, _path, _maps, _toPart) = (job, path, maps, job.Counterpart.Frame.Inverse());

    /// <summary>The pair, after a prediction for a program.</summary>
    /// <param name="job">The job.</param>
    /// <param name="path">The program before, interpreted.</param>
    /// <param name="maps">The features mapped onto it.</param>
    /// <param name="piece">The estimate of the measured piece.</param>
    /// <param name="cuts">The cuts of each run of the program to cut.</param>
    /// <returns>Null if the outline does not tell: fewer than two places, one direction of all normals, or several planes.</returns>
    public static PairAssembly? Estimate(
        MatingJob job, NcPath path, IReadOnlyList<FeatureMap> maps, PieceEstimate piece, Func<RunEstimate, RunPath> cuts)
    {
        if (maps.Select(m => m.Feature.Plane).Distinct().Count() > 1)
        {
            return null;
        }

        var pair = new PairEstimator(job, path, maps);
        var compared = piece.Places();
        foreach (var run in compared.GroupBy(p => p.Run))
        {
            pair.AddElements(run.Key, [.. run], cuts(run.Key), 1 + (compared.Count / MostPlaces));
        }

        foreach (var run in piece.Runs.Where(r => r.Run.Elements.Count == 0))
        {
            pair.AddWhole(run, cuts(run));
        }

        return pair.Assembled() is { } assembled ? assembled with { UnknownForms = piece.UnknownForms() } : null;
    }

    private PairAssembly? Assembled()
    {
        if (_places.Count < 2 || _places.TrueForAll(p => (p.Normal - _places[0].Normal).Length < SameDirection))
        {
            return null;
        }

        double[] gaps = [.. _places.Select(p => p.GapMm)];
        var motions = new PairMotions(
            [.. _places.Select(p => p.Place)], [.. _places.Select(p => p.Normal)], gaps.Max(Math.Abs));
        var seat = PairSeat.Find(motions, gaps);
        var pair = new PairAssembly
        {
            Assembles = true,
            Probability = 1,
            Contacts = [.. seat.Contacts.Select(Contact)],
            RoundCorners = [
                .. InsideCorners.Find(_job, _path, _maps).Select(c => new PairCorner(BlockOf(c.Before), BlockOf(c.After), c.OverlapMm))],
            Play = seat.Play,
            Gaps = [
                .. _places.Select((p, k) => (p, Mm: seat.GapsMm[k])).Where(g => g.p.IsBetween)
                    .Select(g => new PairGap(_maps[g.p.Feature].Feature.Name, g.p.Place, g.p.Normal, g.Mm))],
        };
        if (seat.TightestMm is null)
        {
            return pair;
        }

        var draws = PairDraws.Draw(motions, gaps, _factors);
        return pair with
        {
            Assembles = draws.Probability >= 0.5,
            Probability = draws.Probability,
            TightestMm = draws.MedianMm,
            Interval95Mm = new(draws.FromMm, draws.ToMm),
        };
    }

    private PairContact Contact(int place) => new(
        _places[place].Place,
        _maps[_places[place].Feature].Feature.Name,
        BlockOf(_places[place].Motion));

    private string BlockOf(int motion) => _path.Program.NameOf(_path.Program[_path.Motions[motion].Block]);

    // A key point on an element says nothing of its own where the boundary between the points is compared: it is measured with an error,
    // which the estimate has smoothed. A cut at another depth makes the same boundary once more.
    private void AddElements(RunEstimate run, ComparedPlace[] compared, RunPath cuts, int step)
    {
        var between = compared.Where(p => p.Point < 0).Select(p => p.Terms[0].Stretch).ToHashSet();
        ComparedPlace[] places = [
            .. compared.Where(p => p.Terms.Count > 0 && IsFirstPass(run, p)
                && (p.Point < 0 || p.Terms.Count > 1 || p.Terms[0].Weight != 1 || !between.Contains(p.Terms[0].Stretch)))];
        places = [.. places.Where((p, i) => p.Point >= 0 || i % step == 0 || IsEnd(i))];
        if (places.Length == 0)
        {
            return;
        }

        _factors.Add(JointFactor.Factor(_places.Count, run.Field.Together([.. places.Select(p => p.Terms)])));
        foreach (var place in places)
        {
            var beyond = place.GapMm - place.KeptMm - place.ResidualMm;
            Add(place.Feature, place.Place, place.Normal, cuts, place.NominalMm, beyond, isBetween: place.Point < 0);
        }

        // The first or the last place of an element, where a part touches most often.
        bool IsEnd(int i) => i == 0 || i == places.Length - 1 || ElementOf(i - 1) != ElementOf(i) || ElementOf(i + 1) != ElementOf(i);

        int ElementOf(int i) => places[i].Point >= 0 ? -1 : places[i].Terms[0].Stretch;
    }

    private bool IsFirstPass(RunEstimate run, ComparedPlace place) => place.Terms.All(
        t => run.PassesOf(t).All(pass => _maps.Any(m => ReferenceEquals(m.Passes[0], pass))));

    private void Add(int feature, Point2 place, Vector2 normal, RunPath cuts, double nominalMm, double beyondMm, bool isBetween)
    {
        var foot = cuts.FootOf(place, normal);
        _places.Add(new(
            feature, _toPart.Apply(place), _toPart.Apply(normal), nominalMm - foot.DistanceMm + beyondMm, foot.Motion, isBetween));
    }

    // A circle or slot is estimated as a whole: how it is shifted, how it grows, and with flanks how it turns and stretches.
    private void AddWhole(RunEstimate run, RunPath cuts)
    {
        var feature = run.Points[0].Feature;
        var pass = _maps[feature].Passes[0];
        if (!run.Run.Contains(pass))
        {
            return;
        }

        var shape = WholeShape.Around(run, _path, pass);
        _factors.Add(new(_places.Count, shape.FactorAround(_maps[feature].Feature.FormMm)));
        foreach (var (place, normal) in shape.Places)
        {
            var moved = place + (normal * shape.DeviationAt(place, normal));
            Add(feature, moved, normal, cuts, run.Run.Radius, run.Points[0].GapMm, isBetween: true);
        }
    }

    private sealed record PairPlace(int Feature, Point2 Place, Vector2 Normal, double GapMm, int Motion, bool IsBetween);
}

using ErrorMatching.Geometry;
using ErrorMatching.Measurement;
using ErrorMatching.Nc;

namespace ErrorMatching.Mating;

/// <summary>A run of cuts that follow one another, among them the passes of features: what the tool leaves there is one boundary.</summary>
internal sealed class BoundaryRun
{
    private const MotionFlags Compensation = MotionFlags.CompensationLeft | MotionFlags.CompensationRight;

    // Longest way before the first and behind the last pass that can shape the boundary of the features, mm, in tool diameters and beyond.
    private const double BesideMm = 10;

    // Cosine of the largest angle between the normal of a motion and the way to its foot beside the motion.
    private const double BesideCosine = 0.9999;

    // Sine of the smallest angle at which two elements meet in a corner.
    private const double CornerSine = 0.02;

    private readonly BoundaryElement?[] _elements;

    private readonly RunPath _before;

    private BoundaryRun(
        NcPath path,
        int first,
        int last,
        IReadOnlyList<FeaturePass> passes,
        IReadOnlyList<BoundaryElement> elements,
        bool materialIsLeft,
        double radius)
    {
        (Path, First, Last, Passes, Elements, MaterialIsLeft, Radius) = (path, first, last, passes, elements, materialIsLeft, radius);
        _before = new(path, first, last);
        _elements = new BoundaryElement?[last - first + 1];
        foreach (var element in elements)
        {
            Array.Fill(_elements, element, element.First - first, element.Last - element.First + 1);
        }
    }

    /// <summary>The program before.</summary>
    public NcPath Path { get; }

    /// <summary>Its first motion.</summary>
    public int First { get; }

    /// <summary>Its last motion.</summary>
    public int Last { get; }

    /// <summary>The cuts of features that are estimated with it.</summary>
    public IReadOnlyList<FeaturePass> Passes { get; }

    /// <summary>Its elements in the order of cutting; none for a pass that is estimated on its own.</summary>
    public IReadOnlyList<BoundaryElement> Elements { get; }

    /// <summary>True if the material is left of the path.</summary>
    public bool MaterialIsLeft { get; }

    /// <summary>Distance of the boundary from the path, mm: the radius of the tool, or 0 under cutter compensation.</summary>
    public double Radius { get; }

    /// <summary>True if it ends where it begins.</summary>
    public bool IsClosed => Path.Motions[First].PlaneStart.DistanceTo(Path.Motions[Last].PlaneEnd) < 1e-6;

    /// <summary>The runs of a program that cut given elements.</summary>
    /// <param name="path">The program.</param>
    /// <param name="elements">Elements of one side and tool, in the order of cutting.</param>
    /// <param name="toolDiameterMm">Diameter of the tool.</param>
    public static List<BoundaryRun> Find(NcPath path, IReadOnlyList<BoundaryElement> elements, double toolDiameterMm)
    {
        var runs = new List<BoundaryRun>();
        var group = new List<BoundaryElement>();
        foreach (var element in elements.OrderBy(e => e.First))
        {
            if (group.Count > 0 && !(IsOneSide(group[^1], element) && Follows(path, group[^1].Last, element.First)))
            {
                runs.Add(Around(path, group, toolDiameterMm));
                group.Clear();
            }

            group.Add(element);
        }

        if (group.Count > 0)
        {
            runs.Add(Around(path, group, toolDiameterMm));
        }

        return runs;
    }

    /// <summary>The run of a pass that is estimated on its own.</summary>
    public static BoundaryRun OfPass(NcPath path, FeaturePass pass, double toolDiameterMm) =>
        Around(path, pass.First, pass.Last, [pass], [], pass.Feet[0].MaterialIsLeft, toolDiameterMm);

    /// <summary>Its cuts on a program.</summary>
    public RunPath On(NcPath path) => ReferenceEquals(path, Path) ? _before : new(path, First, Last);

    /// <summary>The nominal boundary at a length along an element, with its normal toward the tool.</summary>
    public (Point2 Place, Vector2 Normal) PlaceAt(BoundaryElement element, double along)
    {
        var starts = element.Pass.Starts;
        var (motion, last) = (element.First, element.Last);
        while (motion < last)
        {
            var middle = (motion + last) / 2;
            (motion, last) = starts[middle - element.Pass.First + 1] < along ? (middle + 1, last) : (motion, middle);
        }

        while (motion < element.Last && !Path.Motions[motion].MovesInPlane)
        {
            motion++;
        }

        var (from, to) = (starts[motion - element.Pass.First], starts[motion - element.Pass.First + 1]);
        var fraction = to > from ? Math.Clamp((along - from) / (to - from), 0, 1) : 0;
        var normal = NormalAt(Path, motion, fraction);
        return (Path.Motions[motion].PlaneAt(fraction) - (normal * Radius), normal);
    }

    /// <summary>The share of each element in the way that the boundary moves at a foot, toward the tool.</summary>
    /// <param name="path">The path of the foot.</param>
    /// <param name="foot">The foot.</param>
    /// <param name="following">The lines beside its elements that their ends take along on this path.</param>
    public IEnumerable<(BoundaryElement Element, double AlongMm, double Weight)> SharesAt(
        NcPath path, RunFoot foot, IReadOnlyList<FollowingLine> following)
    {
        var normal = NormalAt(path, foot.Motion, foot.Fraction);
        var isBeside = Radius == 0 || Math.Abs(foot.Way.Dot(normal)) >= BesideCosine * foot.Way.Length;
        if (ElementOf(foot.Motion) is { } element && isBeside)
        {
            return [(element, Along(element, foot.Motion, foot.Fraction), 1)];
        }

        if (isBeside && !IsBetween(foot.Motion))
        {
            return FollowedBy(foot.Motion, following) is { } followed
                ? [(followed.Element, followed.AtStart ? followed.Element.ToMm : followed.Element.FromMm, Share(path, foot, followed))]
                : [];
        }

        var joint = foot.Fraction < 0.5 ? foot.Motion : foot.Motion + 1;
        var (before, behind) = (Neighbor(joint - 1, -1), Neighbor(joint, 1));
        if (before is null || behind is null)
        {
            return [];
        }

        var (n1, n2) = (NormalAt(path, before.Value, 1), NormalAt(path, behind.Value, 0));
        var way = WayOf(foot, normal);
        if (Math.Abs(n1.Cross(n2)) < CornerSine)
        {
            return ElementOf(before.Value) is { } smooth ? [(smooth, Along(smooth, before.Value, 1), 1)]
                : ElementOf(behind.Value) is { } other ? [(other, Along(other, behind.Value, 0), 1)] : [];
        }

        var (a, b) = (way.Cross(n2) / n1.Cross(n2), n1.Cross(way) / n1.Cross(n2));
        if (FollowedBy(before.Value, following) is { AtStart: false } ahead)
        {
            return [(ahead.Element, ahead.Element.FromMm, way.Dot(n2))];
        }

        if (FollowedBy(behind.Value, following) is { AtStart: true } back)
        {
            return [(back.Element, back.Element.ToMm, way.Dot(n1))];
        }

        var shares = new List<(BoundaryElement, double, double)>();
        if (ElementOf(before.Value) is { } first)
        {
            shares.Add((first, Along(first, before.Value, 1), a));
        }

        if (ElementOf(behind.Value) is { } second)
        {
            shares.Add((second, Along(second, behind.Value, 0), b));
        }

        return shares;
    }

    /// <summary>Where an element and the next one meet; null if other cuts are between them.</summary>
    /// <param name="element">Index of the first of both.</param>
    public ElementJoint? JointAfter(int element)
    {
        if (element < 0 || element + 1 >= Elements.Count)
        {
            return null;
        }

        var (one, other) = (Elements[element], Elements[element + 1]);
        if (Neighbor(one.Last, -1) is not { } last || Neighbor(one.Last + 1, 1) is not { } first
            || !ReferenceEquals(ElementOf(last), one) || !ReferenceEquals(ElementOf(first), other))
        {
            return null;
        }

        var (before, behind) = (NormalAt(Path, last, 1), NormalAt(Path, first, 0));
        var turn = before.Cross(behind);
        return new(before, behind, Math.Abs(turn) < CornerSine ? 0 : turn > 0 == MaterialIsLeft ? 1 : -1);
    }

    /// <summary>The line beside an end of the elements that hides a key point, because the end slid along it past the point's
    /// foot.</summary>
    /// <param name="nominal">The foot on the program before.</param>
    /// <param name="foot">The foot on the program after.</param>
    /// <param name="following">The lines that follow already.</param>
    public FollowingLine? HiddenBy(RunFoot nominal, RunFoot foot, IReadOnlyList<FollowingLine> following)
    {
        if (ElementOf(foot.Motion) is not null || IsBetween(foot.Motion) || FollowedBy(foot.Motion, following) is not null
            || Path.Motions[foot.Motion].IsArc || foot.Fraction is <= 0 or >= 1)
        {
            return null;
        }

        var (before, behind) = (Neighbor(foot.Motion - 1, -1), Neighbor(foot.Motion + 1, 1));
        return SharesAt(Path, nominal, following).Select(s => s.Element).Select(
            e => before is { } b && ReferenceEquals(ElementOf(b), e) ? new FollowingLine(foot.Motion, AtStart: true, e)
                : behind is { } n && ReferenceEquals(ElementOf(n), e) ? new FollowingLine(foot.Motion, AtStart: false, e)
                : null).FirstOrDefault(f => f is not null);
    }

    private static FollowingLine? FollowedBy(int motion, IReadOnlyList<FollowingLine> following) =>
        following.FirstOrDefault(f => f.Motion == motion);

    // The line follows in full at the joint and not at all at its other end.
    private double Share(NcPath path, RunFoot foot, FollowingLine followed)
    {
        var (joint, step) = followed.AtStart ? (followed.Motion - 1, -1) : (followed.Motion + 1, 1);
        var normal = NormalAt(path, Neighbor(joint, step)!.Value, followed.AtStart ? 1 : 0);
        return normal.Dot(WayOf(foot, NormalAt(path, foot.Motion, foot.Fraction))) * (followed.AtStart ? 1 - foot.Fraction : foot.Fraction);
    }

    // Under cutter compensation a point may lie on the path itself.
    private static Vector2 WayOf(RunFoot foot, Vector2 normal) => foot.Way.Length > 1e-9 ? foot.Way.Normalize() : normal;

    /// <summary>True if a pass is part of it.</summary>
    public bool Contains(FeaturePass pass) => pass.First >= First && pass.Last <= Last;

    /// <summary>The element that a motion is part of; null for motions between, before and behind them.</summary>
    public BoundaryElement? ElementOf(int motion) => motion >= First && motion <= Last ? _elements[motion - First] : null;

    /// <summary>Length along the boundary at a place of a motion.</summary>
    public static double Along(BoundaryElement element, int motion, double fraction)
    {
        var (from, to) = (element.Pass.Starts[motion - element.Pass.First], element.Pass.Starts[motion - element.Pass.First + 1]);
        return from + ((to - from) * fraction);
    }

    // The nearest motion with a length, over those that connect elements of one pass and move with them.
    private int? Neighbor(int motion, int step)
    {
        for (var left = Last - First + 1; left > 0; left--, motion += step)
        {
            if (IsClosed && motion < First)
            {
                motion = Last;
            }
            else if (IsClosed && motion > Last)
            {
                motion = First;
            }

            if (motion < First || motion > Last)
            {
                return null;
            }

            if (Path.Motions[motion].MovesInPlane && !IsBetween(motion))
            {
                return motion;
            }
        }

        return null;
    }

    // A motion that shrank to a point had the direction before.
    private Vector2 NormalAt(NcPath path, int motion, double fraction)
    {
        var tangent = (path.Motions[motion].MovesInPlane ? path : Path).Motions[motion].TangentAt(fraction);
        return MaterialIsLeft ? -tangent.Left : tangent.Left;
    }

    // True for an arc that connects two elements of one pass.
    private bool IsBetween(int motion) =>
        ElementOf(motion) is null && Elements.Any(e => motion > e.Last && motion <= e.Pass.Last)
            && Elements.Any(e => motion < e.First && motion >= e.Pass.First);

    private static bool IsOneSide(BoundaryElement one, BoundaryElement other) =>
        one.Pass.Feet[0].MaterialIsLeft == other.Pass.Feet[0].MaterialIsLeft;

    private static bool Follows(NcPath path, int last, int next)
    {
        for (var i = last; i < next; i++)
        {
            if (!Continues(path, i, i + 1))
            {
                return false;
            }
        }

        return true;
    }

    private static bool Continues(NcPath path, int motion, int next)
    {
        var (a, b) = (path.Motions[motion], path.Motions[next]);
        return a.IsCut && b.IsCut && a.Plane == b.Plane && a.IsKnownInPlane && b.IsKnownInPlane
            && (a.Flags & Compensation) == (b.Flags & Compensation)
            && (a.MovesInPlane || a.Start == a.End) && (b.MovesInPlane || b.Start == b.End) && !b.Has(MotionFlags.BadArc);
    }

    private static BoundaryRun Around(NcPath path, List<BoundaryElement> elements, double toolDiameterMm) => Around(
        path,
        elements[0].Pass.First,
        elements[^1].Pass.Last,
        [.. elements.Select(e => e.Pass).Distinct()],
        [.. elements],
        elements[0].Pass.Feet[0].MaterialIsLeft,
        toolDiameterMm);

    // Under cutter compensation the path is the boundary only along the features.
    private static BoundaryRun Around(
        NcPath path,
        int first,
        int last,
        FeaturePass[] passes,
        BoundaryElement[] elements,
        bool materialIsLeft,
        double toolDiameterMm)
    {
        if ((path.Motions[first].Flags & Compensation) != MotionFlags.None)
        {
            return new(path, first, last, passes, elements, materialIsLeft, 0);
        }

        var beside = BesideMm + (2 * toolDiameterMm);
        for (var way = 0.0; way < beside && first > 0 && Continues(path, first - 1, first); way += path.Motions[first].PlaneLength)
        {
            first--;
        }

        for (var way = 0.0;
            way < beside && last < path.Motions.Length - 1 && Continues(path, last, last + 1);
            way += path.Motions[last].PlaneLength)
        {
            last++;
        }

        return new(path, first, last, passes, elements, materialIsLeft, toolDiameterMm / 2);
    }
}

/// <summary>All runs of a program that cut the features of a job. They are known before anything is measured or decided.</summary>
internal sealed class BoundaryRuns
{
    private readonly IReadOnlyList<Point2>[] _theoretical;
    private readonly Dictionary<FeaturePass, int> _features = new(ReferenceEqualityComparer.Instance);
    private readonly Dictionary<FeaturePass, BoundaryElement[]> _elements = new(ReferenceEqualityComparer.Instance);

    /// <summary>Finds the runs.</summary>
    /// <param name="job">The job.</param>
    /// <param name="path">The counterpart's program, interpreted.</param>
    /// <param name="maps">The features mapped onto it, in the order of the job.</param>
    /// <param name="theoretical">The key points as designed.</param>
    public BoundaryRuns(MatingJob job, NcPath path, IReadOnlyList<FeatureMap> maps, MeasurementFile theoretical)
    {
        (Job, Path, Maps) = (job, path, maps);
        _theoretical = [
            .. maps.Select(m => (IReadOnlyList<Point2>)[
                .. m.Feature.Points.Select(l => job.Counterpart.PlaceOf(theoretical[l], m.Feature.Plane, theoretical.File))])];
        for (var f = 0; f < maps.Count; f++)
        {
            foreach (var pass in maps[f].Passes)
            {
                _features.Add(pass, f);
                _elements.Add(
                    pass, [.. maps[f].Feature.Elements(path, pass).Select(e => e with { FormMm = maps[f].Feature.FormMm })]);
            }
        }

        var passes = maps.SelectMany(m => m.Passes);
        All =
        [
            .. passes.Where(p => _elements[p].Length == 0).Select(p => BoundaryRun.OfPass(path, p, job.Counterpart.ToolDiameterMm)),
            .. passes.SelectMany(p => _elements[p]).GroupBy(e => maps[FeatureOf(e.Pass)].Feature.Plane)
                .SelectMany(plane => BoundaryRun.Find(path, [.. plane], job.Counterpart.ToolDiameterMm)),
        ];
    }

    /// <summary>The job.</summary>
    public MatingJob Job { get; }

    /// <summary>The program before.</summary>
    public NcPath Path { get; }

    /// <summary>The features mapped onto it, in the order of the job.</summary>
    public IReadOnlyList<FeatureMap> Maps { get; }

    /// <summary>The runs.</summary>
    public IReadOnlyList<BoundaryRun> All { get; }

    /// <summary>Index of the feature that a pass cuts.</summary>
    public int FeatureOf(FeaturePass pass) => _features[pass];

    /// <summary>The elements of a pass; empty for kinds that are estimated as a whole.</summary>
    public IReadOnlyList<BoundaryElement> ElementsOf(FeaturePass pass) => _elements[pass];

    /// <summary>A key point as designed, in the program's frame.</summary>
    public Point2 TheoreticalOf(int feature, int index) => _theoretical[feature][index];

    /// <summary>What the program before does differently from the theoretical outline at a key point, on the first cut of its feature
    /// (<see cref="BoundaryPoint.BaseMm"/>).</summary>
    public double BaseMm(int feature, int index)
    {
        var pass = Maps[feature].Passes[0];
        var run = All.First(r => r.Passes.Contains(pass));
        return BaseMm(run, run.On(Path).FootOf(TheoreticalOf(feature, index), pass.Feet[index].Normal));
    }

    /// <summary>The same at the foot of a theoretical point. 0 in feedback, where the measured counterpart has it.</summary>
    public double BaseMm(BoundaryRun run, RunFoot nominal) =>
        Job.Compensation.From == CompensationSource.Part ? nominal.DistanceMm - run.Radius : 0;
}

/// <summary>A line beside an end of a run's elements that the end takes along: the joint moves with the element, and the line tilts about
/// its other end.</summary>
/// <param name="Motion">Position of the line in the path.</param>
/// <param name="AtStart">True if the line begins at the end of the element; false if it ends at the start of it.</param>
/// <param name="Element">The element.</param>
internal sealed record FollowingLine(int Motion, bool AtStart, BoundaryElement Element);

/// <summary>Where two elements of a run meet.</summary>
/// <param name="Before">Normal of the first one there, toward the tool.</param>
/// <param name="Behind">Normal of the second one there.</param>
/// <param name="Corner">1 if the tool goes around a corner of the material, -1 in a hollow corner, 0 if one goes on as the other.</param>
internal sealed record ElementJoint(Vector2 Before, Vector2 Behind, int Corner)
{
    /// <summary>Cosine of the angle by which the boundary turns.</summary>
    public double Cosine => Before.Dot(Behind);
}

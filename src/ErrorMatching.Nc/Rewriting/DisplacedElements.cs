using ErrorMatching.Geometry;
using ErrorMatching.Refusals;

namespace ErrorMatching.Nc;

/// <summary>The elements of a path that are displaced: the named ones and the fillets that move with them, each with its wish and the line
/// or circle that carries it afterwards.</summary>
/// <param name="path">The path.</param>
/// <param name="wishes">The wishes for named elements, in path order.</param>
internal sealed class DisplacedElements(NcPath path, IReadOnlyList<ElementWish> wishes)
{
    private const int MostSampled = 100;

    private readonly MotionRuns _asked = new();

    // The wishes of fillets, and of full circles with both ends made exactly alike; the new circles of fillets.
    private readonly Dictionary<int, ElementWish> _otherWishes = [];
    private readonly Dictionary<int, Carrier> _rounded = [];

    /// <summary>The path before the displacement.</summary>
    public NcPath Path => path;

    /// <summary>The least increment of the named blocks, mm: the control's, or a finer one if they are written with more decimals. The
    /// first of them speak for all.</summary>
    public double Increment { get; } = IncrementGrid.Of(path, [.. wishes.Take(MostSampled).Select(w => w.Motion)]);

    /// <summary>The displaced elements as runs of consecutive motions.</summary>
    public MotionRuns Runs { get; } = new();

    /// <summary>The wishes for all elements in path order, including the fillets between them: an unnamed fillet between two displaced
    /// flanks must stay tangent to both, or the tool would leave a mark.</summary>
    public IEnumerable<ElementWish> WithNeighborFillets()
    {
        for (var i = 0; i < wishes.Count; i++)
        {
            _asked.Add(wishes[i].Motion);
            yield return wishes[i];
            var first = wishes[i].Motion + 1;
            var end = i + 1 < wishes.Count ? wishes[i + 1].Motion : first;
            if (end == first || Fillet.Around(path, first) is not { } around || around != (first, end - 1))
            {
                continue;
            }

            var (from, to) = (wishes[i].End, wishes[i + 1].Start);
            for (var motion = first; motion < end; motion++)
            {
                var fillet = new ElementWish(motion, from, (from + to) / 2, to, IsFillet: true);
                _otherWishes.Add(motion, fillet);
                yield return fillet;
            }
        }
    }

    /// <summary>Adds an element, with the new center of an arc.</summary>
    /// <returns>The reason why it cannot be displaced, or null.</returns>
    public Refusal? Add(ElementWish element, PathChange change)
    {
        var motion = path.Motions[element.Motion];
        if (Obstacles.Of(path, motion) is { } obstacle)
        {
            return obstacle;
        }

        if (!motion.IsKnownInPlane)
        {
            return Obstacles.UnknownPlace(path, element.Motion);
        }

        if (DisplacedCarrier.Of(motion, element) is not { } carrier)
        {
            return At(
                motion,
                NcRefusalCodes.ElementFlips,
                "displaced as asked, this element would vanish or turn round. The displacement is larger than the element can take.");
        }

        // Both ends of a full circle are exactly one place.
        var isClosed = motion.PlaneStart.DistanceTo(motion.PlaneEnd) < 1e-9 && (element.End - element.Start).Length < 1e-9;
        Runs.Add(element.Motion);
        if (isClosed)
        {
            _otherWishes[element.Motion] = element with { End = element.Start };
        }

        if (carrier.Circle is { } circle)
        {
            change.SetCenter(element.Motion, circle.Center);
        }

        return null;
    }

    /// <summary>Gives an arc of a fillet its new circle.</summary>
    public void Round(int motion, Circle2 circle) => _rounded.Add(motion, new(null, circle));

    /// <summary>True if a motion is displaced.</summary>
    public bool Contains(int motion) => Runs.Contains(motion);

    /// <summary>True if an arc of a fillet has its new circle.</summary>
    public bool IsRounded(int motion) => _rounded.ContainsKey(motion);

    /// <summary>The wish for an element.</summary>
    public ElementWish WishOf(int motion) =>
        _otherWishes.Count > 0 && _otherWishes.TryGetValue(motion, out var other) ? other : wishes[_asked.IndexOf(motion)];

    /// <summary>The line or circle of an element after its displacement.</summary>
    public Carrier CarrierOf(int motion) =>
        _rounded.TryGetValue(motion, out var fillet) ? fillet : DisplacedCarrier.Of(path.Motions[motion], WishOf(motion))!.Value;

    /// <summary>The name of a motion's block.</summary>
    public string NameOf(int motion) => path.Program.NameOf(path.Program[path.Motions.BlockOf(motion)]);

    /// <summary>A refusal at a motion.</summary>
    public Refusal At(in NcMotion motion, string code, string message) => BlockRefusal.At(path.Program, motion.Block, code, message);
}

using System.Runtime.CompilerServices;
using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>Which motions are arcs, and the values that only arcs have.</summary>
internal sealed class MotionArcs
{
    private readonly RankedBits _areArcs = new();
    private readonly Chunks<Arc> _arcs;

    /// <summary>Creates an empty list.</summary>
    /// <param name="like">A list whose memory is shared for equal arcs.</param>
    /// <param name="inPlace">True if arcs can be taken over from it.</param>
    public MotionArcs(MotionArcs? like, bool inPlace) => _arcs = new(like?._arcs, inPlace);

    /// <summary>The values of a motion that is an arc.</summary>
    public Arc this[int motion] => _arcs[_areArcs.CountTo(motion) - 1];

    /// <summary>True if no motion is an arc.</summary>
    public bool AreNone => _arcs.Count == 0;

    /// <summary>Appends a motion that is an arc.</summary>
    public void Add(in Arc arc)
    {
        _areArcs.Add(true);
        _arcs.Add(arc);
    }

    /// <summary>Appends a motion that is no arc.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void AddOther() => _areArcs.Add(false);

    /// <summary>Number of arcs up to and including a motion.</summary>
    public int CountTo(int motion) => _areArcs.CountTo(motion);

    /// <summary>Appends the arcs of motions that ran ahead, except the first motion, which only marks their start.</summary>
    /// <param name="ahead">The arcs; that list gets no more.</param>
    /// <param name="motions">Number of their motions.</param>
    public void Join(MotionArcs ahead, int motions)
    {
        _areArcs.AddFrom(ahead._areArcs, 1, motions);
        _arcs.Join(ahead._arcs, 0);
    }

    /// <summary>Appends the arcs of the similar list from a motion up to, not including, another.</summary>
    public void TakeOver(MotionArcs like, int first, int end)
    {
        _areArcs.AddFrom(like._areArcs, first, end);
        _arcs.TakeOver(like.CountTo(end - 1));
    }

    /// <summary>Values that only arcs have.</summary>
    public readonly record struct Arc(Point2 Center, int Turns, bool IsVertical);
}

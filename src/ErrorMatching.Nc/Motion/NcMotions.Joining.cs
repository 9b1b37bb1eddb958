using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <content>Motions from elsewhere: from the second thread, or from an earlier run of a similar program.</content>
public sealed partial class NcMotions
{
    /// <summary>Creates a list that may be joined to this one later. Its first motion only marks its start.</summary>
    /// <param name="lead">Motions that end there.</param>
    internal NcMotions Ahead(NcMotions lead)
    {
        var (end, unknown) = (lead.AssumedEnd(lead.Length - 1), lead._motions[lead.Length - 1].UnknownEnd);
        var motions = new NcMotions(_like?._ahead);
        motions.Add(new(-1, MotionKind.Rapid, CoordinatePlane.XY, MotionFlags.None, end, end, default, 0, 0, 0, unknown, unknown));
        return motions;
    }

    /// <summary>True if the last motion ends exactly where a list of <see cref="Ahead"/> begins.</summary>
    internal bool EndsWhereBegins(NcMotions ahead) => Length > 0 && _motions[Length - 1].SameEnd(ahead._motions[0]);

    /// <summary>Appends the motions of a list of <see cref="Ahead"/> except its first; that list gets no more motions.</summary>
    internal void Join(NcMotions ahead)
    {
        if (ahead.Length == 1)
        {
            return;
        }

        var first = Length;
        _settings.Join(ahead._settings, ahead.Length);
        foreach (var (motion, start) in ahead._starts)
        {
            if (motion > 0)
            {
                _starts[first + motion - 1] = start;
            }
        }

        HasPoints |= ahead.HasPoints;
        FollowBlocks &= ahead.FollowBlocks;
        _lastBlock = ahead._lastBlock;
        _arcs.Join(ahead._arcs, ahead.Length);
        _motions.Join(ahead._motions, 1);
        _ahead = ahead;
    }

    /// <summary>True if the next motions would be stored as in the similar list after its first n motions: this list has n motions too,
    /// and the last one is equal in all that affects the next.</summary>
    internal bool EndsAsAfter(int motions) =>
        Length == motions && motions > 0 && _motions[motions - 1].SameEnd(_like!._motions[motions - 1])
        && _settings[motions - 1].SameAs(_like._settings[motions - 1])
        && _arcs.CountTo(motions - 1) == _like._arcs.CountTo(motions - 1);

    /// <summary>Appends the motions of the similar list up to, not including, a position. <see cref="EndsAsAfter"/> must be true here,
    /// and none of the motions may jump.</summary>
    internal void TakeOver(int end)
    {
        var (first, like) = (Length, _like!);
        _settings.TakeOver(like._settings, first, end);
        _arcs.TakeOver(like._arcs, first, end);
        _motions.TakeOver(end);
        HasPoints |= like.HasPoints;
        _lastBlock = BlockOf(end - 1);
    }
}

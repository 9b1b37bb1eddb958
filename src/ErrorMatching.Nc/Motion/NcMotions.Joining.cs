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

        // The first of them can have the setting of the last one here. Whether the others start a new setting does not depend on earlier
        // motions.
        var first = Length;
        var setting = ahead._newSettings[1] ? 1 : 0;
        Share(ahead._settings[setting].Feed, ahead._settings[setting].Frame, ahead._areArcs[1]);
        while (++setting < ahead._settingCount)
        {
            AddSetting(ahead._settings[setting]);
        }

        _newSettings.AddFrom(ahead._newSettings, 2, ahead.Length);
        _areArcs.AddFrom(ahead._areArcs, 2, ahead.Length);
        foreach (var (motion, start) in ahead._starts)
        {
            if (motion > 0)
            {
                _starts[first + motion - 1] = start;
            }
        }

        HasPoints |= ahead.HasPoints;
        FollowBlocks &= ahead.FollowBlocks;
        (_lastBlock, _lastFeed, _lastFrame) = (ahead._lastBlock, ahead._lastFeed, ahead._lastFrame);
        _motions.Join(ahead._motions, 1);
        _arcs.Join(ahead._arcs, 0);
        _ahead = ahead;
    }

    /// <summary>True if the next motions would be stored as in the similar list after its first n motions: this list has n motions too,
    /// and the last one is equal in all that affects the next.</summary>
    internal bool EndsAsAfter(int motions) =>
        Length == motions && motions > 0 && _motions[motions - 1].SameEnd(_like!._motions[motions - 1])
        && SettingAt(motions - 1).SameAs(_like.SettingAt(motions - 1))
            && _areArcs.CountTo(motions - 1) == _like._areArcs.CountTo(motions - 1);

    /// <summary>Appends the motions of the similar list up to, not including, a position. <see cref="EndsAsAfter"/> must be true here,
    /// and none of the motions may jump.</summary>
    internal void TakeOver(int behind)
    {
        var (first, like) = (Length, _like!);
        for (var setting = like._newSettings.CountTo(first - 1); setting < like._newSettings.CountTo(behind - 1); setting++)
        {
            AddSetting(like._settings[setting]);
        }

        _newSettings.AddFrom(like._newSettings, first, behind);
        _areArcs.AddFrom(like._areArcs, first, behind);
        _arcs.TakeOver(like._areArcs.CountTo(behind - 1));
        _motions.TakeOver(behind);
        HasPoints |= like.HasPoints;
        _lastBlock = BlockOf(behind - 1);
        (_lastFeed, _lastFrame) = SettingAt(behind - 1);
    }
}

namespace ErrorMatching.Nc;

/// <summary>A call of a machining cycle, with its arguments as read: null for an omitted one, NaN if only the machine knows the
/// value.</summary>
/// <param name="Name">Its name in capitals.</param>
/// <param name="Number">The number of a CYCLE; 0 for others.</param>
/// <param name="Arguments">The arguments.</param>
internal sealed record CycleCall(string Name, int Number, IReadOnlyList<double?> Arguments)
{
    public double? this[int index] => index < Arguments.Count ? Arguments[index] : null;

    /// <summary>True if the program knows the values of these arguments, apart from omitted ones.</summary>
    public bool IsStated(params ReadOnlySpan<int> indexes)
    {
        foreach (var i in indexes)
        {
            if (this[i] is { } value && !double.IsFinite(value))
            {
                return false;
            }
        }

        return true;
    }

    /// <summary>True if all arguments from an index on are omitted or zero.</summary>
    public bool IsAbsent(int from)
    {
        for (var i = from; i < Arguments.Count; i++)
        {
            if (this[i] is not (null or 0))
            {
                return false;
            }
        }

        return true;
    }

    /// <summary>The depth at an argument, given as a position or relative to the reference plane. If both are given and disagree, their
    /// meaning depends on the version of the cycle.</summary>
    public double? DepthOf(int index)
    {
        var (place, reference, below) = (this[index], this[1], this[index + 1]);
        if (below is null or 0)
        {
            // No depth below the reference plane is not a hole: the position applies.
            return place;
        }

        // Without a position, the depth is downward.
        var depth = reference - Math.Abs(below.Value);
        return place is not { } stated || Math.Abs(stated - depth ?? 0) < 1e-9 ? depth : null;
    }
}

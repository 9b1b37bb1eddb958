namespace ErrorMatching.Nc;

/// <summary>
/// A call of a machining cycle, with its arguments as they were when it was read: null where nothing stands, NaN where only the machine
/// knows the value.
/// </summary>
/// <param name="Name">Its name in capital letters.</param>
/// <param name="Number">The number of a CYCLE; 0 for others.</param>
/// <param name="Arguments">The arguments.</param>
internal sealed record CycleCall(string Name, int Number, IReadOnlyList<double?> Arguments)
{
    public double? this[int index] => index < Arguments.Count ? Arguments[index] : null;

    /// <summary>True if these are known to the program, where they stand at all.</summary>
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

    /// <summary>True if nothing but zeros stands from an argument on.</summary>
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

    /// <summary>
    /// The depth at an argument, which is given as a place or below the reference plane; what two values mean that disagree hangs on the
    /// version of the cycle.
    /// </summary>
    public double? DepthOf(int index)
    {
        var (place, reference, below) = (this[index], this[1], this[index + 1]);
        if (below is null or 0)
        {
            // Nothing below the reference plane is no hole: the place counts.
            return place;
        }

        // Without a place it lies where tools go: down.
        var depth = reference - Math.Abs(below.Value);
        return place is not { } stated || Math.Abs(stated - depth ?? 0) < 1e-9 ? depth : null;
    }
}

namespace ErrorMatching.Cell;

/// <summary>The line for a slot: which correction is next.</summary>
/// <remarks>The machine cuts its pieces in an order that people keep, and each piece has its own program. So corrections never overtake:
/// one that is being computed, waits for a person, or failed at the machine blocks those after it until someone decides.</remarks>
internal static class SlotLine
{
    /// <summary>The first in line; null if the line is empty. It goes to the machine only if it is approved.</summary>
    /// <param name="line">The corrections in line, in order of arrival.</param>
    /// <param name="inOrderOfSerial">Whether a job goes by serial number.</param>
    public static Correction? First(IReadOnlyList<Correction> line, Func<string, bool> inOrderOfSerial)
    {
        if (line.Count == 0)
        {
            return null;
        }

        var first = line[0];
        return inOrderOfSerial(first.Job!) ? line.Where(c => c.Job == first.Job).MinBy(c => c.Serial, SerialOrder.Instance) : first;
    }

    /// <summary>All corrections in the order in which they will be sent if nothing changes.</summary>
    /// <param name="line">The corrections in line, in order of arrival.</param>
    /// <param name="inOrderOfSerial">Whether a job goes by serial number.</param>
    public static IReadOnlyList<Correction> Order(IReadOnlyList<Correction> line, Func<string, bool> inOrderOfSerial)
    {
        var bySerial = line.GroupBy(c => c.Job!)
            .Where(j => inOrderOfSerial(j.Key))
            .ToDictionary(j => j.Key, j => new Queue<Correction>(j.OrderBy(c => c.Serial, SerialOrder.Instance)));
        var order = new List<Correction>(line.Count);
        var sent = new HashSet<long>();
        foreach (var next in line)
        {
            // The next one by arrival lets those of its job with lower serial numbers go first.
            while (!sent.Contains(next.Id))
            {
                var first = bySerial.TryGetValue(next.Job!, out var queue) ? queue.Dequeue() : next;
                order.Add(first);
                sent.Add(first.Id);
            }
        }

        return order;
    }
}

/// <summary>Orders serial numbers as people count: digits as numbers, so that 9 comes before 10, everything else by character. Pieces
/// without a serial number come last.</summary>
internal sealed class SerialOrder : IComparer<string?>
{
    /// <summary>The shared instance.</summary>
    public static SerialOrder Instance { get; } = new();

    public int Compare(string? x, string? y)
    {
        if (x is null || y is null)
        {
            return (x is null).CompareTo(y is null);
        }

        var (i, j) = (0, 0);
        while (i < x.Length && j < y.Length)
        {
            int order;
            if (char.IsAsciiDigit(x[i]) && char.IsAsciiDigit(y[j]))
            {
                var a = Digits(x, ref i);
                var b = Digits(y, ref j);
                order = a.Length != b.Length ? a.Length.CompareTo(b.Length) : a.SequenceCompareTo(b);
            }
            else
            {
                order = x[i++].CompareTo(y[j++]);
            }

            if (order != 0)
            {
                return order;
            }
        }

        var rest = (x.Length - i).CompareTo(y.Length - j);
        return rest != 0 ? rest : string.CompareOrdinal(x, y);
    }

    // The digits from a position, without leading zeros.
    private static ReadOnlySpan<char> Digits(string text, ref int at)
    {
        var start = at;
        while (at < text.Length && char.IsAsciiDigit(text[at]))
        {
            at++;
        }

        return text.AsSpan(start..at).TrimStart('0');
    }
}

namespace ErrorMatching.Cell;

/// <summary>The line in front of a slot: who is next.</summary>
/// <remarks>
/// The machine cuts its pieces in an order that people keep, and each piece has a program of its own. So nobody overtakes: what is still being computed, waits for a person, or failed at the machine
/// holds those behind it until somebody decides.
/// </remarks>
internal static class SlotLine
{
    /// <summary>The first in line; null if nobody is. It goes to the machine only if it is approved.</summary>
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

    /// <summary>The first few in the order in which they are sent if nothing changes.</summary>
    public static IReadOnlyList<Correction> Order(IReadOnlyList<Correction> line, Func<string, bool> inOrderOfSerial, int most)
    {
        List<Correction> rest = [.. line];
        var order = new List<Correction>();
        while (order.Count < most && First(rest, inOrderOfSerial) is { } next)
        {
            order.Add(next);
            rest.Remove(next);
        }

        return order;
    }
}

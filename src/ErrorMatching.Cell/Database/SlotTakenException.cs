using System.Globalization;

namespace ErrorMatching.Cell;

/// <summary>Another correction has the slot.</summary>
/// <param name="machine">The machine.</param>
/// <param name="slot">Its slot.</param>
/// <param name="holder">Number of the correction that has it.</param>
public sealed class SlotTakenException(string machine, string slot, long holder)
    : Exception(string.Create(
        CultureInfo.InvariantCulture, $"Slot {slot} of {machine} is taken by correction {holder} until that is released."))
{
    /// <summary>Number of the correction that has the slot.</summary>
    public long Holder => holder;
}

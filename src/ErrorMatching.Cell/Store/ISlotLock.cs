namespace ErrorMatching.Cell;

/// <summary>The right to send to a slot, which one process has at a time. It ends with the process, whatever ends that, and when it is disposed of.</summary>
public interface ISlotLock : IDisposable
{
    /// <summary>Asks whether it is still held: a server may have gone away and given it to another cell.</summary>
    bool IsHeld { get; }
}

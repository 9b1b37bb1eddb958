namespace ErrorMatching.Cell;

/// <summary>The right to send to a slot; one process at a time can hold it. It ends when disposed of, or with the process, however that
/// ends.</summary>
public interface ISlotLock : IDisposable
{
    /// <summary>Checks whether it is still held: a server may have gone away and given it to another cell.</summary>
    bool IsHeld { get; }
}

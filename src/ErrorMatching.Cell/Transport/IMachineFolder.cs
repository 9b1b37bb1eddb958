namespace ErrorMatching.Cell;

/// <summary>The folder of a machine's programs, wherever it is. Names are plain file names; nothing leads out of the folder.</summary>
/// <remarks>
/// Every operation throws a <see cref="TransportException"/> if it did not happen, or may not have; it may then have happened in part, or happen a little later.
/// Writing and renaming read back what they did, because over a network that costs far less together than apart.
/// </remarks>
public interface IMachineFolder
{
    /// <summary>What people call the machine.</summary>
    string Machine { get; }

    /// <summary>Names of what is in the folder.</summary>
    Task<IReadOnlyList<string>> ListAsync(CancellationToken cancellation);

    /// <summary>The bytes of a file; null if there is none of this name.</summary>
    /// <exception cref="TransportException">With <see cref="TransportError.TooLarge"/> if it has more than <paramref name="mostBytes"/>.</exception>
    Task<byte[]?> ReadAsync(string name, long mostBytes, CancellationToken cancellation);

    /// <summary>Writes a file, replacing one of this name, and reads it back. Seen from others it may appear in part.</summary>
    /// <returns>What was read back; whether it is what was written is the caller's to see.</returns>
    Task<byte[]> WriteAsync(string name, ReadOnlyMemory<byte> bytes, CancellationToken cancellation);

    /// <summary>Renames a file over another, if there is one, and reads it back under its new name.</summary>
    /// <returns>What was read back.</returns>
    /// <exception cref="TransportException">With <see cref="TransportError.CannotReplace"/> if the server does not rename over an existing file, or refuses this name for another reason.</exception>
    Task<byte[]> RenameAsync(string from, string to, long mostBytes, CancellationToken cancellation);

    /// <summary>
    /// Renames a file over a program, keeps what was there under a third name, and reads both. So a change of the last moment is not lost
    /// but found there. The program's name has one of the two at every instant; what a cut
    /// leaves under the third name is either of them, whole.
    /// </summary>
    /// <param name="from">The file; it may have the third name already.</param>
    /// <param name="to">The program's name.</param>
    /// <param name="aside">The third name, which nothing else may have. Nothing has it afterward if nothing had the program's name.</param>
    /// <param name="mostBytes">More is not read.</param>
    /// <param name="cancellation">Ends it at once.</param>
    /// <returns>Null if the transport cannot do it: nothing is changed then.</returns>
    Task<ReplacedProgram?> ReplaceAsync(string from, string to, string aside, long mostBytes, CancellationToken cancellation);

    /// <summary>Deletes a file; none of this name is no error.</summary>
    Task DeleteAsync(string name, CancellationToken cancellation);
}

using ErrorMatching.Json;

namespace ErrorMatching.Cell;

/// <summary>The last seen end of the audit trail in a file that the configuration names, such as on another computer. It reveals a store
/// that was set back together with the keys' folder, as by a snapshot of the whole computer.</summary>
/// <param name="file">The file.</param>
internal sealed class SecondWitness(string file)
{
    private const long Most = 1024;

    /// <summary>The file.</summary>
    public string File => file;

    /// <summary>What is remembered there; null if the file is not there.</summary>
    /// <exception cref="PeopleException">With <see cref="PeopleError.KeysUnusable"/>.</exception>
    public AuditWitness? Find()
    {
        try
        {
            if (!System.IO.File.Exists(file)) return null;
            if (new FileInfo(file).Length > Most) throw AuditWitness.Unreadable(file);
            return AuditWitness.Read(SharedFile.ReadAllBytes(file), file);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            throw new PeopleException(
                PeopleError.KeysUnusable,
                $"{file} cannot be read: {e.Message.TrimEnd('.')}. Is the share mounted, and may this account read it?",
                e);
        }
    }

    /// <summary>Saves it: complete, or not at all.</summary>
    /// <exception cref="PeopleException">With <see cref="PeopleError.KeysUnusable"/>.</exception>
    public void Keep(AuditWitness witness)
    {
        var beside = $"{file}.{Guid.NewGuid():N}.new";
        try
        {
            using (var stream = new FileStream(beside, FileMode.CreateNew, FileAccess.Write))
            {
                stream.Write((witness with { Second = null }).Bytes());
                stream.Flush(flushToDisk: true);
            }

            SharedFile.Replace(beside, file);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            throw new PeopleException(
                PeopleError.KeysUnusable,
                $"{file} cannot be written, and the end of the audit trail is not remembered there: {e.Message.TrimEnd('.')}. Is the share "
                    + "mounted, and may this account write to it?",
                e);
        }
        finally
        {
            Discard(beside);
        }
    }

    /// <summary>The message that the file is missing though it was there.</summary>
    public string Missing() =>
        $"{file} is not there, though the end of the audit trail was remembered there: whether the store was set back to an earlier state "
            + "cannot be said. Is its share mounted? Bring the file back, or, if you are sure of the store, begin it again: "
            + "errormatch audit take-over.";

    private static void Discard(string beside)
    {
        try
        {
            System.IO.File.Delete(beside);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            // The share has gone; what failed before says so.
        }
    }
}

namespace ErrorMatching.Cell.Tests;

/// <summary>A lock that is kept on a file is lost with the file.</summary>
public sealed class FileLockTests : IDisposable
{
    private readonly string _folder = Directory.CreateTempSubdirectory("errormatch-lock-").FullName;

    public void Dispose() => Directory.Delete(_folder, true);

    [Fact]
    public void A_lock_whose_file_was_removed_is_not_held()
    {
        var file = Path.Combine(_folder, "cell.db.1.lock");
        using var first = FileLock.TryTake(file)!;
        Assert.True(first.IsHeld);

        // Windows does not let anybody remove it.
        if (OperatingSystem.IsWindows())
        {
            return;
        }

        File.Delete(file);
        Assert.False(first.IsHeld, "Its file is gone, and it is held.");
        using var second = FileLock.TryTake(file)!;
        Assert.True(second.IsHeld);
        Assert.False(first.IsHeld, "Another one has it, and it is held.");
    }

    [Fact]
    public void A_lock_on_a_file_that_stayed_from_before_is_held()
    {
        var file = Path.Combine(_folder, "cell.db.1.lock");
        FileLock.TryTake(file)!.Dispose();
        using var again = FileLock.TryTake(file)!;

        Assert.True(again.IsHeld);
        Assert.Null(FileLock.TryTake(file));
        Assert.True(again.IsHeld);
    }
}

using ErrorMatching.Cell;

namespace ErrorMatching.Peers.Tests;

/// <summary>What every machine's folder does, whatever its transport.</summary>
internal static class MachineFolderLaws
{
    private static CancellationToken Token => TestContext.Current.CancellationToken;

    /// <summary>Fails the test if a law is broken.</summary>
    /// <param name="open">The folder.</param>
    /// <param name="disk">Where it is on this disk.</param>
    public static async Task HoldAsync(IMachineFolder open, string disk)
    {
        string On(string name) => Path.Combine(disk, name);
        var bytes = new byte[3000];
        new Random(5).NextBytes(bytes);

        Assert.Empty(await open.ListAsync(Token));
        Assert.Null(await open.ReadAsync("P1.MPF", 10, Token));
        await open.DeleteAsync("P1.MPF", Token);
        await Fails(TransportError.Denied, () => open.RenameAsync("P1.MPF", "P2.MPF", 10, Token));

        Assert.Equal(bytes, await open.WriteAsync("P1.MPF.new", bytes, Token));
        Assert.Equal(bytes, File.ReadAllBytes(On("P1.MPF.new")));
        Assert.Equal(bytes, await open.RenameAsync("P1.MPF.new", "P1.MPF", bytes.Length, Token));
        Assert.Equal(["P1.MPF"], await open.ListAsync(Token));
        Assert.Equal(bytes, await open.ReadAsync("P1.MPF", bytes.Length, Token));
        await Fails(TransportError.TooLarge, () => open.ReadAsync("P1.MPF", bytes.Length - 1, Token));

        // Text stays what it is, line ends and all, and what was longer does not stay behind.
        byte[] text = [(byte)'G', (byte)'1', 13, 10, 10, 13, 0, 255, 26];
        Assert.Equal(text, await open.WriteAsync("P1.MPF", text, Token));
        Assert.Equal(text, File.ReadAllBytes(On("P1.MPF")));
        Assert.Equal(Array.Empty<byte>(), await open.WriteAsync("empty", ReadOnlyMemory<byte>.Empty, Token));
        Assert.Equal(Array.Empty<byte>(), await open.ReadAsync("empty", 10, Token));

        const string odd = "probe log (2), #3; 100$ a&b=c+d~.txt";
        Assert.Equal(text, await open.WriteAsync(odd, text, Token));
        Assert.Equal(text, File.ReadAllBytes(On(odd)));
        Assert.Equal(text, await open.ReadAsync(odd, 100, Token));
        Assert.Equal(
            new[] { "P1.MPF", "empty", odd }.Order(StringComparer.Ordinal), (await open.ListAsync(Token)).Order(StringComparer.Ordinal));
        Assert.Equal(text, await open.RenameAsync(odd, "P1.MPF", 100, Token));
        await open.DeleteAsync("empty", Token);
        Assert.Equal(["P1.MPF"], await open.ListAsync(Token));

        // A pipe waits for a writer that never comes, and the machine's other slots with it.
        using (var made = System.Diagnostics.Process.Start("mkfifo", [On("pipe")]))
            await made.WaitForExitAsync(Token);
        var refused = await Assert.ThrowsAsync<TransportException>(() => open.ReadAsync("pipe", 10, Token));
        Assert.True(refused.Error is TransportError.NotAFile or TransportError.Denied, refused.Message);
        File.Delete(On("pipe"));

        foreach (var name in new[] { "../P1.MPF", "a/b", "a\nDELE P1.MPF", "a\"b", "-x", "*", "~\\x" })
        {
            await Fails(TransportError.Denied, () => open.ReadAsync(name, 10, Token));
            await Fails(TransportError.Denied, () => open.WriteAsync(name, text, Token));
            await Fails(TransportError.Denied, () => open.RenameAsync(name, "P2.MPF", 10, Token));
            await Fails(TransportError.Denied, () => open.RenameAsync("P1.MPF", name, 10, Token));
            await Fails(TransportError.Denied, () => open.DeleteAsync(name, Token));
        }

        var sender = new ProgramSender(open, _ => true);
        await sender.SendAsync("P1.MPF", SentProgram.Hash(text), bytes, "17", Token);
        Assert.Equal(bytes, File.ReadAllBytes(On("P1.MPF")));
        await sender.RecoverAsync("P1.MPF", Token);
        Assert.Equal(["P1.MPF"], Directory.EnumerateFileSystemEntries(disk).Select(f => Path.GetFileName(f)!));
    }

    /// <summary>Fails the test unless the work fails with this error, for the machine named first.</summary>
    public static async Task<TransportException> Fails(TransportError error, Func<Task> work)
    {
        var failure = await Assert.ThrowsAsync<TransportException>(work);
        Assert.True(failure.Error == error, $"{error} expected, {failure.Error} came: {failure.Message}");
        Assert.StartsWith("mill: ", failure.Message);
        return failure;
    }
}

using System.Security.Cryptography;
using System.Text;
using ErrorMatching.Cell;

namespace ErrorMatching.Peers.Tests;

/// <summary>A program at a machine that is sent while something breaks, seen on the server's disk.</summary>
internal sealed class SentProgram(string folder, string name)
{
    /// <summary>Length of the new program.</summary>
    public const int Bytes = 2048;

    private static readonly byte[] OldBytes = Encoding.ASCII.GetBytes("%\nO0100 (OLD)\nG1 X1. Y2.\nM30\n%\n");

    private static CancellationToken Token => TestContext.Current.CancellationToken;

    /// <summary>The new program, of 2 KB.</summary>
    public static byte[] New { get; } = MakeNew();

    public static byte[] Old => OldBytes;

    private string PathOf => Path.Combine(folder, name);

    /// <summary>SHA-256 of a program, as it is told to a sender.</summary>
    public static string Hash(ReadOnlySpan<byte> bytes) => Convert.ToHexStringLower(SHA256.HashData(bytes));

    /// <summary>A sender to a machine. Old and new program are kept elsewhere.</summary>
    public static ProgramSender Sender(IMachineFolder machine) => new(machine, h => h == Hash(OldBytes) || h == Hash(New));

    /// <summary>Puts the old program there, and nothing else.</summary>
    public void Reset()
    {
        foreach (var file in Leftovers())
            File.Delete(file);
        File.WriteAllBytes(PathOf, OldBytes);
    }

    /// <summary>Sends the new program, and says what came of it.</summary>
    public async Task<TransportException?> SendAsync(IMachineFolder machine, CancellationToken? cancellation = null)
    {
        try
        {
            await Sender(machine).SendAsync(name, Hash(OldBytes), New, "17", cancellation ?? Token);
            return null;
        }
        catch (TransportException failure)
        {
            return failure;
        }
    }

    /// <summary>Fails the test unless the program is the old one or the new one, whole.
    /// Between two steps it may be absent with both halves beside it.</summary>
    /// <returns>True for the new one.</returns>
    public bool IsWhole(string after, bool inTwoSteps = false)
    {
        if (!File.Exists(PathOf))
        {
            Assert.True(inTwoSteps, $"{name} is gone after {after}.");
            Assert.Contains(Leftovers(), f => File.ReadAllBytes(f).SequenceEqual(OldBytes));
            Assert.Contains(Leftovers(), f => File.ReadAllBytes(f).SequenceEqual(New));
            return false;
        }

        var there = File.ReadAllBytes(PathOf);
        Assert.True(there.SequenceEqual(OldBytes) || there.SequenceEqual(New), $"{name} has {there.Length} bytes after {after}.");
        return there.SequenceEqual(New);
    }

    /// <summary>Recovers, and fails the test unless the machine then has one program, whole, and nothing else of this name.</summary>
    public async Task RecoverAsync(IMachineFolder machine, string after)
    {
        await Sender(machine).RecoverAsync(name, Token);
        IsWhole(after + ", recovered");
        Assert.Empty(Leftovers());
    }

    /// <summary>Recovers and sends again, and fails the test unless the machine then has the new program and nothing else of this
    /// name.</summary>
    public async Task MendAsync(IMachineFolder machine, string after)
    {
        await RecoverAsync(machine, after);
        await Sender(machine).SendAsync(name, Hash(File.ReadAllBytes(PathOf)), New, "18", Token);
        Assert.True(IsWhole(after + ", sent again"));
        Assert.Empty(Leftovers());
    }

    /// <summary>Files of transfers.</summary>
    public string[] Leftovers() =>
        [.. Directory.GetFiles(folder).Where(f => Path.GetFileName(f).StartsWith(name + ".", StringComparison.Ordinal))];

    private static byte[] MakeNew()
    {
        var text = new StringBuilder("%\nO0100 (NEW)\n");
        for (var n = 0; text.Length < Bytes; n++)
            text.Append(System.Globalization.CultureInfo.InvariantCulture, $"N{n} G1 X{n * 0.125:0.000} Y{n * n * 0.001:0.000}\n");
        return Encoding.ASCII.GetBytes(text.ToString()[..Bytes]);
    }
}

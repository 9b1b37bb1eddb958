using System.Text;
using Avalonia.Input;
using Avalonia.Input.Platform;
using ErrorMatching.Hmi.Platform;

namespace ErrorMatching.Hmi.Tests;

/// <summary>What is copied in a spreadsheet is pasted in the station, and the other way round: the clipboard of X11, with another
/// connection as the other program.</summary>
public sealed class ClipboardTests
{
    private const string Cells = "A1\t12.5000\t−0.0312\r\nB1\t7.2500\t測試 😀\r\n";

    [Fact]
    public async Task Text_goes_to_other_programs_and_comes_from_them()
    {
        var session = Drawing.Needed();
        XServer.Present();
        await session.RunAsync(async () =>
        {
            var server = XServer.Connect();
            var foreign = new ForeignProgram(server);
            var clipboard = new X11Clipboard();
            Assert.Null(await clipboard.TryGetDataAsync());

            await CopyAsync(clipboard, Cells);
            Assert.Equal(Cells, await foreign.PasteAsync("UTF8_STRING"));
            Assert.Equal(Cells, await foreign.PasteAsync("text/plain;charset=utf-8"));
            Assert.Equal("TARGETS UTF8_STRING other", await foreign.PasteAsync("TARGETS"));
            Assert.Null(await foreign.PasteAsync("STRING"));
            Assert.Null(await foreign.PasteAsync("image/png"));
            Assert.Equal(Cells, await PasteAsync(clipboard));

            var large = string.Concat(Enumerable.Repeat(Cells, 20_000));
            await CopyAsync(clipboard, large);
            Assert.Equal(large, await foreign.PasteAsync("UTF8_STRING"));

            var copying = foreign.CopyAsync(Encoding.UTF8.GetBytes(Cells), 1);
            Assert.Equal(Cells, await PasteAsync(clipboard));
            await copying;
            Assert.Null(await clipboard.TryGetInProcessDataAsync());

            copying = foreign.CopyAsync(Encoding.UTF8.GetBytes(large), 1, piece: 100_000);
            Assert.Equal(large, await PasteAsync(clipboard));
            await copying;

            // A program that offers no text.
            copying = foreign.CopyAsync([], 2);
            Assert.Null(await PasteAsync(clipboard));
            await copying;

            await CopyAsync(clipboard, "abc");
            Assert.Equal("abc", await foreign.PasteAsync("STRING"));
            await clipboard.ClearAsync();
            Assert.Null(await foreign.PasteAsync("UTF8_STRING"));
        });
    }

    private static Task CopyAsync(X11Clipboard clipboard, string text)
    {
        var transfer = new DataTransfer();
        transfer.Add(DataTransferItem.CreateText(text));
        return clipboard.SetDataAsync(transfer);
    }

    private static async Task<string?> PasteAsync(X11Clipboard clipboard) =>
        await clipboard.TryGetDataAsync() is { } data ? await data.TryGetTextAsync() : null;
}

using Avalonia.Input;
using ErrorMatching.Hmi.Platform;

namespace ErrorMatching.Hmi.Tests;

/// <summary>Keys of Windows, whose numbers are the same on every system.</summary>
public sealed class Win32KeysTests
{
    [Theory]
    [InlineData('A', Key.A)]
    [InlineData('Z', Key.Z)]
    [InlineData('0', Key.D0)]
    [InlineData('9', Key.D9)]
    [InlineData(0x60, Key.NumPad0)]
    [InlineData(0x69, Key.NumPad9)]
    [InlineData(0x70, Key.F1)]
    [InlineData(0x7B, Key.F12)]
    [InlineData(0x87, Key.F24)]
    [InlineData(0x0D, Key.Enter)]
    [InlineData(0x1B, Key.Escape)]
    [InlineData(0xBE, Key.OemPeriod)]
    [InlineData(0xE5, Key.ImeProcessed)]
    [InlineData(0xFF, Key.None)]
    public void A_virtual_key_is_the_key_of_the_same_name(int key, Key expected) => Assert.Equal(expected, Win32Keys.Of(key));
}

# Installs the station, or console and cell, from the folder that this script is in. Run again, it updates or repairs.
#   powershell -ExecutionPolicy Bypass -File install.ps1                      as administrator for everybody, otherwise for you alone
#   powershell -ExecutionPolicy Bypass -File install.ps1 -Config C:\cell\cell.json     and a shortcut that opens this cell
# docs/install.md says what it does.
param(
    [ValidateSet('', 'AllUsers', 'CurrentUser')] [string] $For = '',
    # Where the program goes. It must be empty, or have been installed by this script.
    [string] $Target = '',
    # The station's configuration: the Start menu then has an entry that opens it.
    [string] $Config = '',
    # No shortcuts, no "Open with", no PATH and no entry in Windows' list of apps.
    [switch] $FilesOnly
)
. (Join-Path $PSScriptRoot 'install-steps.ps1')

$source = $PSScriptRoot
$name = @($Products.Keys | Where-Object { Test-Path -LiteralPath (Join-Path $source $Products[$_].Program) -PathType Leaf })
if ($name.Count -ne 1 -or -not (Test-Path -LiteralPath (Join-Path $source $SumsName) -PathType Leaf)) {
    throw "$source is not an unpacked archive of ErrorMatching for Windows."
}
$name = $name[0]
$product = $Products[$name]

if (-not $FilesOnly -and -not (Test-Windows)) { throw 'Only -FilesOnly is possible here: this is not Windows.' }
$isAdministrator = (Test-Windows) -and (Test-Administrator)
$isForAll = if ($For -eq '') { $isAdministrator } else { $For -eq 'AllUsers' }
if ($isForAll -and -not $isAdministrator) {
    throw 'Installing for all users needs an administrator. -For CurrentUser installs for you alone.'
}
if ($Config -ne '') {
    if ($name -ne 'station') { throw '-Config is for the station only.' }
    if (-not (Test-Path -LiteralPath $Config -PathType Leaf)) { throw "There is no file $Config." }
    $Config = (Resolve-Path -LiteralPath $Config).ProviderPath
}

if ($Target -eq '') {
    $base = if ($isForAll) { $env:ProgramFiles } else { Join-Path ([Environment]::GetFolderPath('LocalApplicationData')) 'Programs' }
    $Target = Join-Path (Join-Path $base 'ErrorMatching') $product.Folder
}
$Target = $ExecutionContext.SessionState.Path.GetUnresolvedProviderPathFromPSPath($Target).TrimEnd('\', '/')
$source = (Resolve-Path -LiteralPath $source).ProviderPath.TrimEnd('\', '/')
if ($Target -eq $source) { throw 'This is the installed program already. Run install.ps1 of an unpacked archive.' }
$ends = [IO.Path]::DirectorySeparatorChar
if ("$Target$ends".StartsWith("$source$ends", 'OrdinalIgnoreCase') -or "$source$ends".StartsWith("$Target$ends", 'OrdinalIgnoreCase')) {
    throw "$Target and $source are one inside the other. Unpack the archive somewhere else."
}
foreach ($folder in $Target, (Split-Path -Parent $Target)) {
    if (Test-Link $folder) { throw "$folder is a link to another place. Name the place itself with -Target." }
}
if (Test-Path -LiteralPath $Target -PathType Leaf) { throw "$Target is a file." }

# Everything that could prevent it is checked before anything changes.
$before = @{}
$isFilesOnly = [bool] $FilesOnly
$shortcuts = @{}
if ($name -eq 'station' -and -not $FilesOnly) {
    $shortcuts['ErrorMatching demonstration.lnk'] = '--demo'
    if ($Config -ne '') { $shortcuts['ErrorMatching station.lnk'] = "`"$Config`"" }
}
$menuEntries = @($shortcuts.Keys)
if (Test-Path -LiteralPath $Target) {
    $manifest = Read-Manifest $Target
    if ($null -eq $manifest) {
        if (@([IO.Directory]::GetFileSystemEntries($Target)).Count -gt 0) {
            throw "$Target has files that install.ps1 did not write. Choose another folder with -Target, or move them away."
        }
    }
    elseif ($manifest.product -ne $name) { throw "$Target has $($Products[$manifest.product].Title). Choose another folder with -Target." }
    elseif ($manifest.isForAll -ne $isForAll -and @($manifest.files).Count -gt 0) {
        throw "$Target was installed for $(if ($manifest.isForAll) { 'all users' } else { 'one user' }). Run its uninstall.ps1 first."
    }
    else {
        $before = Get-Listed $manifest
        # What is registered stays registered, for uninstall.ps1 to find.
        if ($before.Count -gt 0) {
            $isFilesOnly = $isFilesOnly -and $manifest.isFilesOnly
            $menuEntries = @($menuEntries + @($manifest.shortcuts) | Sort-Object -Unique)
        }
    }
}
$program = Join-Path $Target $product.Program
Assert-NotRunning $program

$after = Read-Sums $source
foreach ($relative in $after.Keys) {
    $place = Join-Below $Target $relative
    $file = Join-Below $source $relative
    if (Test-LinkBelow $source $relative) { throw "$file is a link, or behind one. Unpack the archive again." }
    if (-not (Test-Path -LiteralPath $file -PathType Leaf) -or -not (Test-Sum $file $after[$relative])) {
        throw "$file is missing or damaged. Unpack the archive again. Nothing was changed."
    }
    if (Test-LinkBelow $Target $relative) { throw "$place is a link, or behind one. Remove it first. Nothing was changed." }
    if (-not $before.ContainsKey($relative) -and (Test-Path -LiteralPath $place)) {
        throw "$place is not from install.ps1, and would be replaced. Move it away first. Nothing was changed."
    }
}
# The list itself goes along, so that an installed program can be checked as well.
$files = @($after.Keys) + $SumsName | Sort-Object
$after[$SumsName] = Get-Sum (Join-Path $source $SumsName)
$version = [Diagnostics.FileVersionInfo]::GetVersionInfo((Join-Path $source $product.Program)).ProductVersion
$version = ([string] $version -split '\+')[0]

function New-Manifest($Listed) {
    [ordered] @{
        product = $name; version = $version; isForAll = [bool] $isForAll; isFilesOnly = $isFilesOnly
        shortcuts = $menuEntries
        files = @($Listed.Keys | Sort-Object | ForEach-Object { [ordered] @{ path = $_; sha256 = $Listed[$_] } })
    }
}

# First the list, of both versions, then the files: if this is interrupted, running it again or uninstall.ps1 knows what is whose.
$both = @{}
foreach ($relative in $before.Keys) { $both[$relative] = $before[$relative] }
foreach ($relative in $after.Keys) {
    $both[$relative] = if ($before.ContainsKey($relative)) { $before[$relative] + ' ' + $after[$relative] } else { $after[$relative] }
}
[IO.Directory]::CreateDirectory($Target) | Out-Null
Write-Manifest $Target (New-Manifest $both)

$copied = 0
foreach ($relative in $files) {
    $place = Join-Below $Target $relative
    if (Test-Path -LiteralPath $place -PathType Leaf) {
        if (Test-Sum $place $after[$relative]) { continue }
        if (-not (Test-Sum $place $before[$relative])) {
            $kept = "$place.changed"
            for ($i = 2; Test-Path -LiteralPath $kept; $i++) { $kept = "$place.changed-$i" }
            [IO.File]::Move($place, $kept)
            Write-Warning "$relative was changed after it was installed. What it was is now $kept."
        }
    }
    [IO.Directory]::CreateDirectory((Split-Path -Parent $place)) | Out-Null
    [IO.File]::Copy((Join-Path $source $relative), "$place$PartSuffix", $true)
    [IO.File]::SetAttributes("$place$PartSuffix", 'Normal')
    # Where the archive was downloaded, Windows would ask at each start whether to trust the program: you decided that by installing it.
    if (Test-Windows) { Unblock-File -LiteralPath "$place$PartSuffix" -ErrorAction SilentlyContinue }
    if ([IO.File]::Exists($place)) { [IO.File]::Delete($place) }
    [IO.File]::Move("$place$PartSuffix", $place)
    $copied++
}

# What only the version before had.
$old = @{}
foreach ($relative in $before.Keys) { if (-not $after.ContainsKey($relative)) { $old[$relative] = $before[$relative] } }
foreach ($left in @(Remove-Listed $Target $old)) { Write-Warning "Left where it is: $left" }
Write-Manifest $Target (New-Manifest $after)

if (-not $FilesOnly) {
    $uninstall = "powershell.exe -NoProfile -ExecutionPolicy Bypass -File `"$(Join-Path $Target 'uninstall.ps1')`""
    $size = [int] (($files | ForEach-Object { (New-Object IO.FileInfo (Join-Path $Target $_)).Length } | Measure-Object -Sum).Sum / 1KB)
    Set-Values (Get-UninstallKey $isForAll $product) @{
        DisplayName = $product.Title; DisplayVersion = $version; Publisher = 'ErrorMatching contributors'; InstallLocation = $Target
        DisplayIcon = $program; UninstallString = $uninstall; EstimatedSize = $size; NoModify = 1; NoRepair = 1
    }
    if ($name -eq 'console') {
        Edit-Path $isForAll { param($entries) Add-Entry $entries $Target }
    }
    else {
        # An entry of "Open with" for .json files. It does not become their default program: .json belongs to other programs as well.
        $open = Get-OpenWithKey $isForAll $product
        Set-Values $open @{ FriendlyAppName = $product.Title }
        Set-Values "$open\SupportedTypes" @{ '.json' = '' }
        Set-Values "$open\shell\open\command" @{ '(default)' = "`"$program`" `"%1`"" }

        $menu = Get-MenuFolder $isForAll
        [IO.Directory]::CreateDirectory($menu) | Out-Null
        $shell = New-Object -ComObject WScript.Shell
        foreach ($entry in $shortcuts.Keys) {
            $shortcut = $shell.CreateShortcut((Join-Path $menu $entry))
            $shortcut.TargetPath = $program
            $shortcut.Arguments = $shortcuts[$entry]
            $shortcut.WorkingDirectory = $Target
            $shortcut.Save()
        }
    }
}

"$($product.Title) $version is in $Target ($copied of $($files.Count) files copied)."
if (-not $FilesOnly -and $name -eq 'console') { 'New command prompts find errormatch; those that are open do not.' }

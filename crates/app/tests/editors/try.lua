-- What Neovim shows of `main.awl` with the profile of the book: what is wrong, and what a word means.
local WAIT_MS = 60000

local function main()
  vim.cmd.edit("main.awl")
  assert(vim.wait(WAIT_MS, function() return #vim.lsp.get_clients({ bufnr = 0 }) > 0 end), "no server")
  assert(vim.wait(WAIT_MS, function() return #vim.diagnostic.get(0) > 0 end), "no diagnostics")
  local client = vim.lsp.get_clients({ bufnr = 0 })[1]
  for _, one in ipairs(vim.diagnostic.get(0)) do
    io.stdout:write(("line %d: %s\n"):format(one.lnum + 1, one.code))
  end
  vim.api.nvim_win_set_cursor(0, { 3, 3 })
  local where = vim.lsp.util.make_position_params(0, client.offset_encoding)
  local answer = client:request_sync("textDocument/hover", where, WAIT_MS, 0)
  io.stdout:write(("hover: %s\n"):format(vim.split(answer.result.contents.value, "\n")[1]))
end

local ok, why = pcall(main)
if not ok then
  io.stdout:write(("failed: %s\n"):format(why))
end
vim.cmd("qa!")
